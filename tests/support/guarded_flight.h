// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include "guided_vehicle.h"
#include "onboard_capture.h"

namespace rtob::test
{
inline constexpr double kRadius_m = 0.3, kMargin_m = 0.15;
inline constexpr double kLoad_s = 1.5;  // beyond a limit: what else this computer does

/// Waits until something holds, for so long at most.
template <class Holds>
bool eventually(double patience_s, Holds&& holds)
{
    for (const double end_s = unix_time_s() + patience_s; unix_time_s() < end_s; wait_s(0.01))
        if (holds()) return true;
    return holds();
}

/// Between the vehicle's middle and the wall that it looks at.
inline double to_wall_m(const GuidedVehicle& vehicle)
{
    return 12 - vehicle.pose().x;
}

class GuardedFlight : public Onboard
{
 protected:
    /// In a room of 12 m x 6 m, 4 m from the wall ahead; north is not the map's x axis.
    GuardedFlight()
        : vehicle_({8, 3, 0}, 0.7),
          laser_(
              laserPort(), devices::model_a2(),
              vehicle_.laserIn(Room({{0, 0, 12, 0}, {12, 0, 12, 6}, {12, 6, 0, 6}, {0, 6, 0, 0}}))),
          program_(RTOB_ONBOARD, {write(config())})
    {
    }
    [[nodiscard]] std::string config() const
    {
        return "[Autopilot]\nlink = udp:127.0.0.1:" + std::to_string(vehicle_.port()) +
               "\n[Pilot]\nenabled = true\n[Stick]\nmax_speed_mps = 1\n"
               "[VehicleLimits]\nradius_m = 0.3\nmargin_m = 0.15\n"
               "[Guard]\nno_return_is_free = true\n";
    }
    /// Until the guard lets the vehicle move.
    void takeOff(double ahead)
    {
        vehicle_.push(ahead, 0);
        ASSERT_TRUE(eventually(20, [&] { return vehicle_.commandedSpeed() > 0.1; }));
    }
    nlohmann::json land()
    {
        program_.send(SIGTERM);
        const auto result = program_.wait();
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return summary_of(flights().back());
    }

    GuidedVehicle vehicle_;
    devices::RplidarOnTerminal laser_;
    RunningProgram program_;
};
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "guided_vehicle.h"
#include "onboard_capture.h"

namespace rtob::test
{
namespace
{
constexpr double kRadius_m = 0.3, kMargin_m = 0.15;
constexpr double kFrame_s = 0.6;  // the limits here are 0.5 s; the rest is this computer's load

/// Waits until something holds, for so long at most.
template <class Holds>
bool eventually(double patience_s, Holds&& holds)
{
    for (const double end_s = unix_time_s() + patience_s; unix_time_s() < end_s; wait_s(0.01))
        if (holds()) return true;
    return holds();
}

/// Between the vehicle's middle and the wall that it looks at.
double to_wall_m(const GuidedVehicle& vehicle)
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

TEST_F(GuardedFlight, StopsShortOfAWallThatThePilotPushesAt)
{
    takeOff(1);
    double nearest_m = 100;
    const bool stops = eventually(
        20,
        [&]
        {
            nearest_m = std::min(nearest_m, to_wall_m(vehicle_));
            return to_wall_m(vehicle_) < 1 && vehicle_.speed() < 0.02;
        });
    EXPECT_TRUE(stops) << to_wall_m(vehicle_) << " m, " << vehicle_.speed() << " m/s";
    for (int i = 0; i < 100; ++i, wait_s(0.01))
        nearest_m = std::min(nearest_m, to_wall_m(vehicle_));
    EXPECT_GT(nearest_m, kRadius_m + 0.05);             // within the margin on a busy computer, too
    EXPECT_LT(nearest_m, kRadius_m + kMargin_m + 0.3);  // it does go there
    EXPECT_TRUE(vehicle_.hasRead("Guard: SLOWED") || vehicle_.hasRead("Guard: GUIDED"));
    EXPECT_TRUE(vehicle_.hasRead("Guard: BLOCKED, 0."));

    // As the autopilot wants to hear it.
    EXPECT_EQ(vehicle_.target().type_mask, 0x05C7);
    EXPECT_EQ(vehicle_.target().coordinate_frame, 1);
    EXPECT_NEAR(vehicle_.obstacles().distances[0], 100 * to_wall_m(vehicle_), 10);
    EXPECT_EQ(vehicle_.obstacles().frame, 12);
    EXPECT_GT(vehicle_.obstacleMessages(), 20u);

    // And back again.
    vehicle_.push(-1, 0);
    EXPECT_TRUE(eventually(5, [&] { return to_wall_m(vehicle_) > 1; }));
    const auto summary = land();
    EXPECT_GT(summary["guard"]["BLOCKED"], 0);
    EXPECT_EQ(summary["guard"]["decisions"] > 50, true);
    EXPECT_LT(summary["guard"]["slowest_decision_ms"], 20);
    EXPECT_EQ(vehicle_.commandedSpeed(), 0);  // the last command of all
    std::cout << "nearest " << nearest_m << " m, " << summary["guard"] << "\n";
}

TEST_F(GuardedFlight, StopsWhenTheLaserFreezes)
{
    takeOff(-0.6);
    laser_.inject(devices::LineFault::Stall, 4);
    const double frozen_s = unix_time_s();
    ASSERT_TRUE(eventually(3, [&] { return vehicle_.commandedSpeed() == 0; }));
    EXPECT_LT(unix_time_s() - frozen_s, 0.5 + kFrame_s);  // max_scan_age_s
    EXPECT_TRUE(eventually(1, [&] { return vehicle_.hasRead("Guard: STALE"); }));
    // It still is told so, all the time, and flies on when the laser is back.
    const auto targets = vehicle_.targets();
    wait_s(0.5);
    EXPECT_GT(vehicle_.targets(), targets + 5);
    EXPECT_TRUE(eventually(15, [&] { return vehicle_.commandedSpeed() > 0.1; }));
    land();
}

TEST_F(GuardedFlight, StopsWhenTheSticksAreLost)
{
    takeOff(-0.6);
    vehicle_.dropStick();
    const double dropped_s = unix_time_s();
    ASSERT_TRUE(eventually(3, [&] { return vehicle_.commandedSpeed() == 0; }));
    EXPECT_LT(unix_time_s() - dropped_s, 0.5 + kFrame_s);  // [Stick] max_age_s
    EXPECT_TRUE(eventually(1, [&] { return vehicle_.hasRead("Guard: NO_STICK"); }));
    vehicle_.push(-0.6, 0);
    EXPECT_TRUE(eventually(2, [&] { return vehicle_.commandedSpeed() > 0.1; }));
    land();
}
}  // namespace
}  // namespace rtob::test

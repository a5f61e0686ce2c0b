// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/spread.h>

#include "guarded_flight.h"
#include "held_thread.h"

namespace rtob::test
{
namespace
{
class HungThread : public GuardedFlight
{
 protected:
    void SetUp() override
    {
        if (!may_hold_threads()) GTEST_SKIP() << "ptrace is not allowed here";
    }

    /// Holds a thread until the vehicle is told to stand still, and lets it fly on.
    /// @return how long it took until it was told so [s]
    float holdUntilItStops(const std::string& thread, const std::string& word)
    {
        double stopped_s = 0;
        {
            const double held_s = unix_time_s();
            const HeldThread held(program_.id(), thread);
            EXPECT_TRUE(eventually(3, [&] { return vehicle_.commandedSpeed() == 0; })) << thread;
            stopped_s = unix_time_s() - held_s;
            EXPECT_TRUE(eventually(2, [&] { return vehicle_.hasRead(word); })) << word;
            // It still is told so, all the time.
            const auto targets = vehicle_.targets();
            wait_s(0.4);
            EXPECT_GT(vehicle_.targets(), targets + 4);
            EXPECT_EQ(vehicle_.commandedSpeed(), 0);
        }
        EXPECT_TRUE(eventually(10, [&] { return vehicle_.commandedSpeed() > 0.1; }));
        return static_cast<float>(stopped_s);
    }
};

TEST_F(HungThread, TheVehicleStopsWhenNothingIsDecided)
{
    takeOff(-0.6);
    std::vector<float> stops_s;
    for (int i = 0; i < 5; ++i) stops_s.push_back(holdUntilItStops("guard", "Guard: STALLED"));
    EXPECT_LT(percentile(stops_s, 1), 0.1 + kLoad_s);  // [VehicleLimits] period_s
    EXPECT_GE(land()["guard"]["stalls"], 5);
    std::cout << "told to stop after " << percentile(stops_s, 0.5) << " s p50, "
              << percentile(stops_s, 1) << " s at most\n";
}

TEST_F(HungThread, TheVehicleStopsWhenTheLocalisationHangs)
{
    takeOff(-0.6);
    const float stop_s = holdUntilItStops("localise", "Guard: STALE");
    EXPECT_LT(stop_s, 0.5 + kLoad_s);  // [Guard] max_scan_age_s
    land();
    std::cout << "told to stop after " << stop_s << " s\n";
}

TEST_F(HungThread, TheVehicleStopsWhenTheLaserDriverHangs)
{
    takeOff(-0.6);
    const float stop_s = holdUntilItStops("Laser", "Guard: STALE");
    EXPECT_LT(stop_s, 0.5 + kLoad_s);  // [Guard] max_scan_age_s
    land();
}
}  // namespace
}  // namespace rtob::test

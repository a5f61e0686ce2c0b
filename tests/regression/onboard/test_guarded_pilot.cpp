// SPDX-License-Identifier: BSD-3-Clause
#include "guarded_flight.h"

namespace rtob::test
{
namespace
{
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
    EXPECT_GT(summary["guard"]["slowest_decision_ms"], 0);  // how long is a benchmark's matter
    EXPECT_EQ(vehicle_.commandedSpeed(), 0);                // the last command of all
    std::cout << "nearest " << nearest_m << " m, " << summary["guard"] << "\n";
}

TEST_F(GuardedFlight, StopsWhenTheLaserFreezes)
{
    takeOff(-0.6);
    laser_.inject(devices::LineFault::Stall, 4);
    const double frozen_s = unix_time_s();
    ASSERT_TRUE(eventually(3, [&] { return vehicle_.commandedSpeed() == 0; }));
    EXPECT_LT(unix_time_s() - frozen_s, 0.5 + kLoad_s);  // max_scan_age_s
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
    EXPECT_LT(unix_time_s() - dropped_s, 0.5 + kLoad_s);  // [Stick] max_age_s
    EXPECT_TRUE(eventually(1, [&] { return vehicle_.hasRead("Guard: NO_STICK"); }));
    vehicle_.push(-0.6, 0);
    EXPECT_TRUE(eventually(2, [&] { return vehicle_.commandedSpeed() > 0.1; }));
    land();
}
}  // namespace
}  // namespace rtob::test

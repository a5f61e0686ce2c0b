// SPDX-License-Identifier: BSD-3-Clause
#include <command_watch.h>
#include <gtest/gtest.h>
#include <guard_messages.h>

using namespace rtob;
using Eigen::Vector2d;

namespace
{
/// A scan of 360 beams, counter-clockwise from the nose, all of one range.
struct RoundScan
{
    std::vector<float> ranges_m;
    GuardScan scan;

    explicit RoundScan(float range_m) : ranges_m(360, range_m)
    {
        scan.stamp_s = 100;
        scan.step_rad = 2 * M_PI / 360;
        scan.ranges_m = ranges_m.data();
        scan.beams = ranges_m.size();
        scan.max_range_m = 6;
    }
};
}  // namespace

TEST(VelocityTarget, TurnsTheVehiclesAxesNorth)
{
    // The nose looks east: ahead is east, left is north.
    const auto target = velocity_target({0.5, 0.2}, 0.3, M_PI / 2, 100);
    EXPECT_NEAR(target.vx, 0.2, 1e-6);
    EXPECT_NEAR(target.vy, 0.5, 1e-6);
    EXPECT_EQ(target.vz, 0);
    EXPECT_NEAR(target.yaw_rate, -0.3, 1e-6);
    // Bits of what is left aside: x y z, three accelerations, yaw; not the yaw rate.
    EXPECT_EQ(target.type_mask, 1 + 2 + 4 + 64 + 128 + 256 + 1024);
    EXPECT_EQ(target.coordinate_frame, 1);
}

TEST(MotionOf, TurnsNorthToTheVehiclesAxes)
{
    AutopilotNews news;
    news.attitude.time_s = news.position.time_s = 100;
    news.attitude.message.yaw = static_cast<float>(M_PI / 2);
    news.attitude.message.yawspeed = 0.1F;
    news.position.message.vx = 0.2F;  // north: to the left
    news.position.message.vy = 0.5F;
    const auto motion = motion_of(news, 0.3, 100.1);
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->velocity_vehicle.x(), 0.5, 1e-6);
    EXPECT_NEAR(motion->velocity_vehicle.y(), 0.2, 1e-6);
    EXPECT_NEAR(motion->yaw_rate_radps, -0.1, 1e-6);
    EXPECT_FALSE(motion_of(news, 0.3, 100.4));
}

TEST(ObstacleDistance, CountsSectorsClockwiseAndTakesTheNearest)
{
    RoundScan round(5);
    round.ranges_m[90] = 2;    // left: sector 54
    round.ranges_m[91] = 1.5;  // 89 degrees counter-clockwise of that: still there
    const auto message = obstacle_distance(round.scan, false);
    EXPECT_EQ(message.distances[54], 150);
    EXPECT_EQ(message.distances[53], 150);  // the sectors beside it, too
    EXPECT_EQ(message.distances[55], 150);
    EXPECT_EQ(message.distances[18], 500);
    EXPECT_EQ(message.increment, 5);
    EXPECT_EQ(message.frame, 12);
    EXPECT_EQ(message.max_distance, 600);
    EXPECT_EQ(message.time_usec, 100'000'000u);
}

TEST(ObstacleDistance, KeepsFromAutopilotsWhatTheyMisread)
{
    RoundScan round(0);
    round.ranges_m[0] = 0.02F;  // nearer than min_distance: told as just beyond it
    round.ranges_m[180] = 6;    // free: one more than max_distance
    auto message = obstacle_distance(round.scan, false);
    EXPECT_EQ(message.min_distance, 10);
    EXPECT_EQ(message.distances[0], 11);
    EXPECT_EQ(message.distances[36], 601);
    EXPECT_EQ(message.distances[18], 65535);  // not known
    message = obstacle_distance(round.scan, true);
    EXPECT_EQ(message.distances[18], 601);
    EXPECT_EQ(message.distances[1], 11);  // what is free does not push away what is there
}

TEST(CommandWatch, StopsWhenDecisionsStopComing)
{
    CommandWatch watch(0.3);
    EXPECT_EQ(watch.take(99).state, "STALLED");  // none yet
    EXPECT_EQ(watch.stalls(), 0u);
    GuardCommand command;
    command.target.vx = 1;
    command.state = "FREE";
    watch.put(command, 100);
    EXPECT_EQ(watch.take(100.29).target.vx, 1);
    const GuardCommand stop = watch.take(100.31);
    EXPECT_EQ(stop.target.vx, 0);
    EXPECT_EQ(stop.target.type_mask, 0x05C7);
    EXPECT_EQ(stop.state, "STALLED");
    EXPECT_TRUE(stop.is_warning);
    static_cast<void>(watch.take(101));
    EXPECT_EQ(watch.stalls(), 1u);               // one, however long
    EXPECT_EQ(watch.take(50).state, "STALLED");  // the clock was set back
    watch.put(command, 102);
    EXPECT_EQ(watch.take(102).state, "FREE");
}

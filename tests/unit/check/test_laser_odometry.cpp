// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <house.h>
#include <near_pose.h>
#include <rtob/check/laser_odometry.h>

namespace rtob::test
{
namespace
{
/// A lap through the house with the odometry's word for each step.
template <class Odometry>
void expect_follows(Odometry&& odometry_step)
{
    const Room room = house();
    LaserOdometry laser;
    static_cast<void>(laser.add(room.scan_vehicle(pose_in_house(0)), std::nullopt));
    Pose2 pose_first_now;
    for (int k = 1; k <= house_lap_scans; ++k)
    {
        const Pose2 truth = between(pose_in_house(k - 1), pose_in_house(k));
        const auto step = laser.add(room.scan_vehicle(pose_in_house(k)), odometry_step(truth));
        ASSERT_TRUE(step.is_measured) << k;
        EXPECT_THAT(step.pose_prev_now, IsNearPose(truth, 0.03, 0.02)) << k;
        pose_first_now = compose(pose_first_now, step.pose_prev_now);
    }
    // It closes no loop: a percent of the 20 m.
    EXPECT_THAT(pose_first_now, IsNearPose(Pose2{}, 0.2, 0.05));
}

TEST(LaserOdometry, FollowsWithoutOdometry)
{
    expect_follows([](const Pose2&) { return std::optional<Pose2>(); });
}

TEST(LaserOdometry, IsNotLedAstrayByBadOdometry)
{
    expect_follows(
        [](const Pose2& step) {
            return std::optional<Pose2>({-step.x, 0.3, -3 * step.yaw});
        });
}

TEST(LaserOdometry, StandingIsNoMotion)
{
    const auto points = house().scan_vehicle(pose_in_house(10));
    LaserOdometry laser;
    static_cast<void>(laser.add(points, std::nullopt));
    for (int k = 0; k < 50; ++k)
        EXPECT_THAT(laser.add(points, std::nullopt).pose_prev_now, IsNearPose(Pose2{}, 1e-3, 1e-3));
}

TEST(LaserOdometry, ACorridorLeavesThePositionOpen)
{
    const Room corridor({{-100, 0, 100, 0}, {-100, 2, 100, 2}});
    const Room room = room_4x3();
    const auto holds = [](const Room& world, const Pose2& first, const Pose2& second)
    {
        LaserOdometry laser;
        static_cast<void>(laser.add(world.scan_vehicle(first), std::nullopt));
        const auto step = laser.add(world.scan_vehicle(second), std::nullopt);
        EXPECT_TRUE(step.is_measured);
        return step.holds_position;
    };
    EXPECT_FALSE(holds(corridor, {0, 1, 0}, {0.05, 1, 0}));
    EXPECT_TRUE(holds(room, {1.6, 1.2, 0}, {1.65, 1.2, 0}));
}

TEST(LaserOdometry, StartsAnewAfterAViewWithoutPoints)
{
    const Room room = house();
    LaserOdometry laser;
    static_cast<void>(laser.add(room.scan_vehicle(pose_in_house(0)), std::nullopt));
    EXPECT_FALSE(laser.add({}, std::nullopt).is_measured);
    EXPECT_FALSE(laser.add(room.scan_vehicle(pose_in_house(1)), std::nullopt).is_measured);
    EXPECT_TRUE(laser.add(room.scan_vehicle(pose_in_house(2)), std::nullopt).is_measured);
}
}  // namespace
}  // namespace rtob::test

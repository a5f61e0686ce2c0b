// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/drivers/autopilot_frames.h>
#include <rtob/drivers/autopilot_pose.h>

namespace rtob
{
namespace
{
constexpr double pi = 3.14159265358979323846;

TEST(AutopilotFrames, TurnEveryAxisAsTheTableSays)
{
    struct Row
    {
        Vector3 flu, frd;
    };
    for (const Row& row :
         {Row{{1, 0, 0}, {1, 0, 0}},    // ahead stays ahead
          Row{{0, 1, 0}, {0, -1, 0}},   // left is minus right
          Row{{0, 0, 1}, {0, 0, -1}}})  // up is minus down
    {
        const auto turned = turn_over(row.flu);
        EXPECT_EQ(row.frd.x, turned.x);
        EXPECT_EQ(row.frd.y, turned.y);
        EXPECT_EQ(row.frd.z, turned.z);
        const auto back = turn_over(turned);
        EXPECT_EQ(row.flu.y, back.y);
    }
}

TEST(AutopilotFrames, NoseLeftIsYawMinus90)
{
    EXPECT_DOUBLE_EQ(-pi / 2, turn_over(Pose2{0, 0, pi / 2}).yaw);
    const auto angles = turn_over(RollPitchYaw{0.1, 0.2, 0.3});
    EXPECT_EQ(0.1, angles.roll);
    EXPECT_EQ(-0.2, angles.pitch);  // nose up is positive in FRD, nose down in FLU
    EXPECT_EQ(-0.3, angles.yaw);
}

TEST(AutopilotFrames, EastNorthUpIsNorthEastDownWithPlacesChanged)
{
    const auto ned = swap_enu_ned({1, 2, 3});
    EXPECT_EQ(2, ned.x);
    EXPECT_EQ(1, ned.y);
    EXPECT_EQ(-3, ned.z);
    EXPECT_NEAR(pi / 2, swap_enu_ned_yaw(0), 1e-15);     // facing east
    EXPECT_NEAR(0, swap_enu_ned_yaw(pi / 2), 1e-15);     // facing north
    EXPECT_NEAR(-pi / 2, swap_enu_ned_yaw(-pi), 1e-12);  // facing west
}

TEST(AutopilotFrames, HeadingTurnsTheLocalFrameToNorth)
{
    // The map's x axis points east: 2 m ahead are 2 m east, 1 m to its right is 1 m south.
    const auto north = to_north({2, 1, 0}, pi / 2);
    EXPECT_NEAR(-1, north.x, 1e-15);
    EXPECT_NEAR(2, north.y, 1e-15);
}

TEST(AutopilotFrames, QuaternionOfAYaw)
{
    const auto q = quaternion_of({0, 0, pi / 2});
    EXPECT_NEAR(std::sqrt(0.5), q[0], 1e-15);
    EXPECT_NEAR(0, q[1], 1e-15);
    EXPECT_NEAR(0, q[2], 1e-15);
    EXPECT_NEAR(std::sqrt(0.5), q[3], 1e-15);
    const auto roll = quaternion_of({pi, 0, 0});
    EXPECT_NEAR(1, roll[1], 1e-15);
}

TimedPose pose_ahead_left()
{
    TimedPose pose;
    pose.time_s = 1700000000.25;
    pose.pose_map_vehicle = {3, 1, pi / 2};  // 3 m ahead, 1 m left, looking left
    pose.velocity_vehicle = {0.5, 0.25, 0.1};
    pose.covariance << 4, 1, 2, 1, 9, 3, 2, 3, 16;
    pose.resets = 5;
    return pose;
}

TEST(AutopilotPose, IsFrdWithoutAHeading)
{
    const auto message = odometry_of(pose_ahead_left(), 0);
    EXPECT_EQ(1'700'000'000'250'000u, message.time_usec);
    EXPECT_EQ(20, message.frame_id);
    EXPECT_EQ(12, message.child_frame_id);
    EXPECT_FLOAT_EQ(3, message.x);
    EXPECT_FLOAT_EQ(-1, message.y);
    EXPECT_NEAR(std::sqrt(0.5), message.q[0], 1e-6);
    EXPECT_NEAR(-std::sqrt(0.5), message.q[3], 1e-6);
    EXPECT_FLOAT_EQ(0.5f, message.vx);
    EXPECT_FLOAT_EQ(-0.25f, message.vy);
    EXPECT_FLOAT_EQ(-0.1f, message.yawspeed);
    EXPECT_EQ(5, message.reset_counter);
    // xx, yy and aa stay; xy and xa change their sign, ya changes it twice.
    EXPECT_FLOAT_EQ(4, message.pose_covariance[0]);
    EXPECT_FLOAT_EQ(-1, message.pose_covariance[1]);
    EXPECT_FLOAT_EQ(-2, message.pose_covariance[5]);
    EXPECT_FLOAT_EQ(9, message.pose_covariance[6]);
    EXPECT_FLOAT_EQ(3, message.pose_covariance[10]);
    EXPECT_FLOAT_EQ(16, message.pose_covariance[20]);
    EXPECT_TRUE(std::isnan(message.velocity_covariance[0]));
}

TEST(AutopilotPose, IsNedWithOne)
{
    // x of the map points east: 3 m ahead are east, 1 m left is north; looking left is north.
    const auto message = vision_estimate_of(pose_ahead_left(), pi / 2);
    EXPECT_NEAR(1, message.x, 1e-6);
    EXPECT_NEAR(3, message.y, 1e-6);
    EXPECT_NEAR(0, message.yaw, 1e-6);
    EXPECT_NEAR(9, message.covariance[0], 1e-5);  // north is the map's left
    EXPECT_NEAR(4, message.covariance[6], 1e-5);
    EXPECT_NEAR(1, message.covariance[1], 1e-5);  // ahead and left are east and north: no mirror
    EXPECT_EQ(5, message.reset_counter);
}
}  // namespace
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/autopilot_frames.h>
#include <rtob/drivers/autopilot_pose.h>

#include <algorithm>
#include <limits>

namespace rtob
{
namespace
{
constexpr std::uint8_t kLocalFrd = 20, kBodyFrd = 12, kVisionEstimator = 2;
constexpr float kUnknownVariance = 1e4f;
constexpr std::uint8_t kFullQuality = 100;

std::uint64_t microseconds(double time_s)
{
    return static_cast<std::uint64_t>(std::llround(1e6 * time_s));
}

/// Where the vehicle is, z down, x of the axis that the heading turns to.
Pose2 local_pose(const TimedPose& pose, double heading_rad)
{
    const Pose2 down = turn_over(pose.pose_map_vehicle);
    const Vector3 turned = to_north({down.x, down.y, 0}, heading_rad);
    return {turned.x, turned.y, wrap_angle(down.yaw + heading_rad)};
}

/// Turning z over changes the signs of what mixes x with y or yaw; the heading turns the plane.
Eigen::Matrix3d local_covariance(const TimedPose& pose, double heading_rad)
{
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    const double c = std::cos(heading_rad), s = std::sin(heading_rad);
    turn << c, s, 0, s, -c, 0, 0, 0, -1;  // the plane's turn after diag(1, -1, -1)
    return turn * pose.covariance * turn.transpose();
}

/// Places in the upper triangle: x x 0, x y 1, x yaw 5, y y 6, y yaw 10, z z 11, roll 15, pitch 18,
/// yaw 20.
std::array<float, 21> upper_triangle(const Eigen::Matrix3d& c)
{
    std::array<float, 21> triangle{};
    triangle[0] = static_cast<float>(c(0, 0));
    triangle[1] = static_cast<float>(c(0, 1));
    triangle[5] = static_cast<float>(c(0, 2));
    triangle[6] = static_cast<float>(c(1, 1));
    triangle[10] = static_cast<float>(c(1, 2));
    triangle[20] = static_cast<float>(c(2, 2));
    triangle[11] = triangle[15] = triangle[18] = kUnknownVariance;
    return triangle;
}
}  // namespace

mavlink::Odometry odometry_of(const TimedPose& pose, double heading_rad)
{
    const Pose2 local = local_pose(pose, heading_rad);
    mavlink::Odometry message;
    message.time_usec = microseconds(pose.time_s);
    message.frame_id = kLocalFrd;
    message.child_frame_id = kBodyFrd;
    message.x = static_cast<float>(local.x);
    message.y = static_cast<float>(local.y);
    const auto q = quaternion_of({0, 0, local.yaw});
    std::transform(
        q.begin(), q.end(), message.q.begin(),
        [](double part) { return static_cast<float>(part); });
    const Pose2 velocity = turn_over(pose.velocity_vehicle);
    message.vx = static_cast<float>(velocity.x);
    message.vy = static_cast<float>(velocity.y);
    message.yawspeed = static_cast<float>(-pose.velocity_vehicle.yaw);
    message.pose_covariance = upper_triangle(local_covariance(pose, heading_rad));
    // NaN first: not known. The velocity is two poses' difference, and no measurement of its own.
    message.velocity_covariance[0] = std::numeric_limits<float>::quiet_NaN();
    message.reset_counter = pose.resets;
    message.estimator_type = kVisionEstimator;
    message.quality = kFullQuality;
    return message;
}

mavlink::VisionPositionEstimate vision_estimate_of(const TimedPose& pose, double heading_rad)
{
    const Pose2 local = local_pose(pose, heading_rad);
    mavlink::VisionPositionEstimate message;
    message.usec = microseconds(pose.time_s);
    message.x = static_cast<float>(local.x);
    message.y = static_cast<float>(local.y);
    message.yaw = static_cast<float>(local.yaw);
    message.covariance = upper_triangle(local_covariance(pose, heading_rad));
    message.reset_counter = pose.resets;
    return message;
}
}  // namespace rtob

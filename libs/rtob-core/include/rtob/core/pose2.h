// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

namespace rtob
{
/// Wraps an angle into [-pi, pi).
[[nodiscard]] inline double wrap_angle(double angle_rad)
{
    constexpr double pi = 3.14159265358979323846;
    const double angle = std::remainder(angle_rad, 2 * pi);  // exact; in [-pi, pi]
    return angle < pi ? angle : -pi;
}

/// A pose in the plane, or the rigid motion that takes points of the inner frame to the outer one:
/// pose_map_vehicle is the vehicle seen from map, and takes vehicle points to map. SI: m, rad.
struct Pose2
{
    double x = 0;
    double y = 0;
    double yaw = 0;  ///< in [-pi, pi) where this file made it
};

[[nodiscard]] inline bool is_finite(const Pose2& pose)
{
    return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw);
}

/// A pose and when it was held.
struct StampedPose2
{
    double time_s = 0;  ///< UNIX time as the log wrote it
    Pose2 pose;         ///< map <- vehicle
};

/// Chains frames: compose(pose_a_b, pose_b_c) = pose_a_c.
[[nodiscard]] inline Pose2 compose(const Pose2& pose_a_b, const Pose2& pose_b_c)
{
    const double c = std::cos(pose_a_b.yaw), s = std::sin(pose_a_b.yaw);
    return {
        pose_a_b.x + c * pose_b_c.x - s * pose_b_c.y, pose_a_b.y + s * pose_b_c.x + c * pose_b_c.y,
        wrap_angle(pose_a_b.yaw + pose_b_c.yaw)};
}

[[nodiscard]] inline Pose2 inverse(const Pose2& pose_a_b)
{
    const double c = std::cos(pose_a_b.yaw), s = std::sin(pose_a_b.yaw);
    return {
        -c * pose_a_b.x - s * pose_a_b.y, s * pose_a_b.x - c * pose_a_b.y,
        wrap_angle(-pose_a_b.yaw)};
}

/// How b is seen from a: between(pose_map_a, pose_map_b) = pose_a_b.
[[nodiscard]] inline Pose2 between(const Pose2& pose_map_a, const Pose2& pose_map_b)
{
    return compose(inverse(pose_map_a), pose_map_b);
}

/// Less than this far apart, and turned by less than this against each other.
[[nodiscard]] inline bool is_near(
    const Pose2& a, const Pose2& b, double distance_m, double turn_rad)
{
    return std::hypot(a.x - b.x, a.y - b.y) < distance_m &&
           std::abs(wrap_angle(a.yaw - b.yaw)) < turn_rad;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <array>
#include <cmath>

/// The one place where our frames (map and vehicle: x ahead, y left, z up; docs/frames.md) and
/// those of flight controllers (x ahead or north, y right or east, z down) meet. Turning z over is
/// its own inverse, so each function serves both directions.
namespace rtob
{
struct Vector3
{
    double x = 0, y = 0, z = 0;
};

/// Seen along x, y and z; radians, right-hand rule, applied in the order yaw, pitch, roll.
struct RollPitchYaw
{
    double roll = 0, pitch = 0, yaw = 0;
};

/// FLU <-> FRD, and map <-> a local frame with z down.
[[nodiscard]] inline Vector3 turn_over(const Vector3& v)
{
    return {v.x, -v.y, -v.z};
}
[[nodiscard]] inline RollPitchYaw turn_over(const RollPitchYaw& a)
{
    return {a.roll, -a.pitch, -a.yaw};
}
[[nodiscard]] inline Pose2 turn_over(const Pose2& pose)
{
    return {pose.x, -pose.y, wrap_angle(-pose.yaw)};
}

/// From a local frame with z down to north-east-down.
/// @param heading_rad of the local x axis, clockwise from north as a compass shows it
[[nodiscard]] inline Vector3 to_north(const Vector3& local, double heading_rad)
{
    const double c = std::cos(heading_rad), s = std::sin(heading_rad);
    return {c * local.x - s * local.y, s * local.x + c * local.y, local.z};
}

/// ENU -> NED and back: x and y change places, z turns over.
[[nodiscard]] inline Vector3 swap_enu_ned(const Vector3& v)
{
    return {v.y, v.x, -v.z};
}
/// A yaw counter-clockwise from east <-> clockwise from north.
[[nodiscard]] inline double swap_enu_ned_yaw(double yaw_rad)
{
    return wrap_angle(1.57079632679489661923 - yaw_rad);
}

/// Body to local, in the order w, x, y, z.
[[nodiscard]] inline std::array<double, 4> quaternion_of(const RollPitchYaw& a)
{
    const double cr = std::cos(a.roll / 2), sr = std::sin(a.roll / 2);
    const double cp = std::cos(a.pitch / 2), sp = std::sin(a.pitch / 2);
    const double cy = std::cos(a.yaw / 2), sy = std::sin(a.yaw / 2);
    return {
        cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy};
}
}  // namespace rtob

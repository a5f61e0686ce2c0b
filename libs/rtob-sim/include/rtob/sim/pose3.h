// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

namespace rtob::sim
{
/// Where the vehicle is in space: x ahead, y to the left, z up; m and rad. It is turned by yaw,
/// then pitch (positive: nose down), then roll (positive: left side up).
struct Pose3
{
    double x = 0, y = 0, z = 0;
    double roll = 0, pitch = 0, yaw = 0;

    [[nodiscard]] Pose2 from_above() const { return {x, y, yaw}; }
};

/// On the way from one pose to a near one; share in [0, 1].
[[nodiscard]] inline Pose3 between(const Pose3& a, const Pose3& b, double share)
{
    const auto mix = [share](double from, double to) { return from + share * (to - from); };
    return {mix(a.x, b.x),         mix(a.y, b.y),
            mix(a.z, b.z),         mix(a.roll, b.roll),
            mix(a.pitch, b.pitch), wrap_angle(a.yaw + share * wrap_angle(b.yaw - a.yaw))};
}
}  // namespace rtob::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gmock/gmock.h>
#include <rtob/core/pose2.h>

#include <cmath>
#include <ostream>

namespace rtob
{
inline void PrintTo(const Pose2& pose, std::ostream* out)
{
    *out << "(" << pose.x << " m, " << pose.y << " m, " << pose.yaw << " rad)";
}

namespace test
{
/// Both coordinates within tol_m and the yaw, across the wrap, within tol_rad.
MATCHER_P3(IsNearPose, expected, tol_m, tol_rad, "is near " + testing::PrintToString(expected))
{
    const double yaw_error_rad = wrap_angle(arg.yaw - expected.yaw);
    *result_listener << "off by " << arg.x - expected.x << " m, " << arg.y - expected.y << " m, "
                     << yaw_error_rad << " rad";
    return std::abs(arg.x - expected.x) <= tol_m && std::abs(arg.y - expected.y) <= tol_m &&
           std::abs(yaw_error_rad) <= tol_rad;
}
}  // namespace test
}  // namespace rtob

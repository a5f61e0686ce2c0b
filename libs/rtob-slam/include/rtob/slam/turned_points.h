// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>

namespace rtob
{
/// Eq. 2 without the shift: turns points of the vehicle frame along the map's axes, seen from the
/// vehicle, as Icp::align wants them.
/// @return the box that holds them, in map.
Box turn_points(
    const Pose2& pose_map_vehicle, const PointsView& points_vehicle, Points& points_turned);
}  // namespace rtob

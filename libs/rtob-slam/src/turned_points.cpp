// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/turned_points.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
Box turn_points(
    const Pose2& pose_map_vehicle, const PointsView& points_vehicle, Points& points_turned)
{
    const auto c = static_cast<float>(std::cos(pose_map_vehicle.yaw));
    const auto s = static_cast<float>(std::sin(pose_map_vehicle.yaw));
    points_turned.clear();
    float min_x = 0, min_y = 0, max_x = 0, max_y = 0;
    for (std::size_t i = 0; i < points_vehicle.size; ++i)
    {
        const float x = c * points_vehicle.x[i] - s * points_vehicle.y[i];
        const float y = s * points_vehicle.x[i] + c * points_vehicle.y[i];
        min_x = std::min(min_x, x);
        max_x = std::max(max_x, x);
        min_y = std::min(min_y, y);
        max_y = std::max(max_y, y);
        points_turned.add(x, y);
    }
    return {
        pose_map_vehicle.x + min_x, pose_map_vehicle.y + min_y, pose_map_vehicle.x + max_x,
        pose_map_vehicle.y + max_y};
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/bent_way.h>

#include <cmath>

namespace rtob
{
namespace
{
/// The step from a to b, both in map, turned by `turn_rad` and set off from `from`.
Pose2 turned_step(const Pose2& from, const Pose2& a, const Pose2& b, double turn_rad)
{
    const double c = std::cos(turn_rad), s = std::sin(turn_rad);
    const double dx = b.x - a.x, dy = b.y - a.y;
    return {from.x + c * dx - s * dy, from.y + s * dx + c * dy, wrap_angle(b.yaw + turn_rad)};
}
}  // namespace

void bend_way(
    const ScanTable& scans, const TravelLog& travel, std::size_t first, const Pose2& end,
    const Pose2& end_now, std::vector<Pose2>& poses)
{
    const double turn_rad = wrap_angle(end_now.yaw - end.yaw);
    const double begin_m = travel.pathAt(first), way_m = travel.path() - begin_m;
    const auto share = [&](std::size_t scan)
    { return way_m > 0 ? (travel.pathAt(scan) - begin_m) / way_m : 1.0; };

    poses.assign(1, scans.pose(first));
    for (std::size_t scan = first + 1; scan < scans.size(); ++scan)
        poses.push_back(turned_step(
            poses.back(), scans.pose(scan - 1), scans.pose(scan), share(scan) * turn_rad));
    const Pose2 arrived = turned_step(poses.back(), scans.pose(scans.size() - 1), end, turn_rad);
    for (std::size_t k = 0; k < poses.size(); ++k)
    {
        poses[k].x += share(first + k) * (end_now.x - arrived.x);
        poses[k].y += share(first + k) * (end_now.y - arrived.y);
    }
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/reference_draw.h>

#include <cstdint>
#include <utility>

namespace rtob::test
{
/// A map as the draw sees it, grown scan by scan.
struct TestMap
{
    Points points_map;
    ScanTable scans;
    VisitIndex visits;

    /// A scan whose points all lie at (px, py) in map.
    void add(
        double time_s, const Pose2& pose_map_vehicle, std::uint32_t points, float px = 0,
        float py = 0)
    {
        add(time_s, pose_map_vehicle, points, [&](std::uint32_t) { return std::pair(px, py); });
    }

    /// A scan with point(0), point(1) ... in map.
    template <class Point>
    void add(double time_s, const Pose2& pose_map_vehicle, std::uint32_t points, const Point& point)
    {
        for (std::uint32_t i = 0; i < points; ++i)
        {
            const auto [x, y] = point(i);
            points_map.add(x, y);
        }
        scans.append(time_s, pose_map_vehicle, points);
        visits.append(pose_map_vehicle.x, pose_map_vehicle.y);
    }

    [[nodiscard]] MapView view() const { return {points_map.view(), scans, visits}; }
};
}  // namespace rtob::test

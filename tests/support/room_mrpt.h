// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/core/Clock.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include "room.h"

namespace rtob::test
{
/// A scan as MRPT has it, the laser at the vehicle's origin. The beams must lie around the front.
[[nodiscard]] inline mrpt::obs::CObservation2DRangeScan scan_observation(
    const Room& room, const Pose2& pose_map_vehicle, double stamp_s, const Laser& laser)
{
    mrpt::obs::CObservation2DRangeScan scan;
    scan.timestamp = mrpt::Clock::fromDouble(stamp_s);
    scan.sensorLabel = "LASER";
    scan.aperture = static_cast<float>(laser.step_rad * static_cast<double>(laser.beams - 1));
    scan.rightToLeft = true;
    scan.maxRange = static_cast<float>(laser.max_range_m);
    const auto ranges = room.ranges(pose_map_vehicle, laser);
    scan.resizeScan(ranges.size());
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
        scan.setScanRange(i, ranges[i]);
        scan.setScanRangeValidity(i, ranges[i] > 0);
    }
    return scan;
}

/// 361 beams from -180 to 180 degrees: symmetric about the front, as MRPT's scans are.
[[nodiscard]] inline Laser mrpt_laser()
{
    constexpr double pi = 3.14159265358979323846;
    return {361, -pi, 2 * pi / 360, 6};
}

[[nodiscard]] inline mrpt::maps::CSimplePointsMap points_map(const Points& points)
{
    mrpt::maps::CSimplePointsMap map;
    for (std::size_t i = 0; i < points.size(); ++i) map.insertPointFast(points.x[i], points.y[i]);
    map.mark_as_modified();
    return map;
}
}  // namespace rtob::test

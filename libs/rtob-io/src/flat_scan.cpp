// SPDX-License-Identifier: BSD-3-Clause
#include "flat_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtob
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;

bool is_range(float range_m)
{
    return std::isfinite(range_m) && range_m > 0;
}

/// Beams from the maximum range on count as no return in CARMEN, so it must lie above every valid
/// one.
float max_range_for(const CObservation2DRangeScan& scan)
{
    float farthest_m = 0;
    for (std::size_t i = 0; i < scan.getScanSize(); ++i)
        if (scan.getScanRangeValidity(i) && is_range(scan.getScanRange(i)))
            farthest_m = std::max(farthest_m, scan.getScanRange(i));
    const float above_m = std::nextafter(farthest_m, std::numeric_limits<float>::infinity());
    return std::max(scan.maxRange, above_m);
}

float carmen_range(float range_m, bool valid, float max_range_m, LogLosses& losses)
{
    if (!is_range(range_m))
    {
        if (valid) ++losses["valid beams whose range is none: they read back as no return"];
        return std::isfinite(range_m) ? range_m : 0;
    }
    if (valid || range_m >= max_range_m) return range_m;
    ++losses["ranges of invalid beams: written as 0, which means no return"];
    return 0;
}
}  // namespace

FlatMount flat_mount(const mrpt::poses::CPose3D& pose_vehicle_laser)
{
    const auto& rotation = pose_vehicle_laser.getRotationMatrix();
    FlatMount mount;
    mount.pose_vehicle_laser = {
        pose_vehicle_laser.x(), pose_vehicle_laser.y(), std::atan2(rotation(1, 0), rotation(0, 0))};
    mount.hangs = rotation(2, 2) < 0;
    mount.tilt_rad = std::asin(std::min(1.0, std::hypot(rotation(2, 0), rotation(2, 1))));
    return mount;
}

CarmenScan to_carmen(const CObservation2DRangeScan& scan, LogLosses& losses)
{
    const std::size_t beams = scan.getScanSize();
    const double aperture_rad = scan.aperture;
    CarmenScan carmen;
    carmen.first_angle_rad = -aperture_rad / 2;
    carmen.step_rad = beams > 1 ? aperture_rad / static_cast<double>(beams - 1) : 0;
    const float max_range_m = max_range_for(scan);
    carmen.max_range_m = max_range_m;
    carmen.accuracy_m = scan.stdError;
    for (std::size_t i = 0; i < beams; ++i)
    {
        carmen.ranges_m.push_back(
            carmen_range(scan.getScanRange(i), scan.getScanRangeValidity(i), max_range_m, losses));
        if (scan.hasIntensity()) carmen.remissions.push_back(scan.getScanIntensity(i));
    }
    if (scan.rightToLeft != flat_mount(scan.sensorPose).hangs) return carmen;
    ++losses["clockwise scans: their beams are written in counter-clockwise order"];
    std::reverse(carmen.ranges_m.begin(), carmen.ranges_m.end());
    std::reverse(carmen.remissions.begin(), carmen.remissions.end());
    return carmen;
}
}  // namespace rtob

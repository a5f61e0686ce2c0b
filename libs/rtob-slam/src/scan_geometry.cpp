// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/slam/scan_geometry.h>

#include <cmath>

namespace rtob
{
void ScanGeometryOptions::validate() const
{
    require(sweep_s >= 0, "sweep_s", sweep_s, ">= 0");
    require(stamp_at >= 0 && stamp_at <= 1, "stamp_at", stamp_at, "in [0, 1]");
    require(floor_margin_m >= 0, "floor_margin_m", floor_margin_m, ">= 0");
    require(ceiling_height_m >= 0, "ceiling_height_m", ceiling_height_m, ">= 0");
}

SweepTiming sweep_timing(std::optional<double> recorded_sweep_s, const ScanGeometryOptions& options)
{
    constexpr double middle = 0.5;
    if (options.sweep_s > 0)
        return {(middle - options.stamp_at) * options.sweep_s, options.sweep_s};
    const double sweep_s = recorded_sweep_s.value_or(0);  // its stamp is that of the first beam
    return {middle * sweep_s, sweep_s};
}

bool ScanGeometry::isSkewed() const
{
    constexpr double least_m = 0.001, least_rad = 0.0005;
    return std::hypot(twist.forward_mps, twist.left_mps) * sweep_s > least_m ||
           std::abs(twist.turn_radps) * sweep_s > least_rad;
}

ScanGeometry scan_geometry(
    const mrpt::poses::CPose3D& pose_vehicle_laser, std::optional<Tilt> tilt,
    std::optional<double> height_m, const SweepTiming& timing, const Twist2& twist,
    const ScanGeometryOptions& options)
{
    ScanGeometry geometry{pose_vehicle_laser};
    if (options.deskew) geometry.twist = twist, geometry.sweep_s = timing.sweep_s;
    if (!options.level || !tilt) return geometry;
    const mrpt::poses::CPose3D attitude(0, 0, 0, 0, tilt->pitch_rad, tilt->roll_rad);
    geometry.pose_level_laser = attitude + pose_vehicle_laser;
    if (!height_m) return geometry;
    // A laser that is itself as low as the margin sees no floor without a tilt.
    constexpr double surely_down_m = 0.05;
    geometry.lowest_m =
        std::min(options.floor_margin_m - *height_m, geometry.pose_level_laser.z() - surely_down_m);
    if (options.ceiling_height_m > 0)
        geometry.highest_m = std::max(
            options.ceiling_height_m - options.floor_margin_m - *height_m,
            geometry.pose_level_laser.z() + surely_down_m);
    return geometry;
}
}  // namespace rtob

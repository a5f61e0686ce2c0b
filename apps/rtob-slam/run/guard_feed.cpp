// SPDX-License-Identifier: BSD-3-Clause
#include "run/guard_feed.h"

#include <algorithm>
#include <cmath>

#include "run/run_counters.h"

namespace rtob
{
namespace
{
// Poses further apart, or older, say nothing of the motion now.
constexpr double kLongestStep_s = 0.5;
}  // namespace

GuardFeed::GuardFeed(const SlamOptions& options)
    : filter_(options.scan_filter), mask_(options.scan_filter.mask_deg), sensor_(options.sensor)
{
}

const GuardScan& GuardFeed::scanOf(const mrpt::obs::CObservation2DRangeScan& scan, double sweep_s)
{
    const std::size_t beams = scan.getScanSize();
    const double side = scan.rightToLeft ? 1 : -1;
    const auto mount = sensor_.mountOf(scan);
    const double turn = mount.getRotationMatrix()(2, 2) < 0 ? -1 : 1;  // hangs: left is right
    scan_.stamp_s = mrpt::Clock::toDouble(scan.timestamp);
    scan_.sweep_s = sweep_s;
    const double first_rad = -0.5 * side * scan.aperture;
    const double step_rad = beams < 2 ? 0 : side * scan.aperture / static_cast<double>(beams - 1);
    scan_.first_bearing_rad = turn * first_rad;
    scan_.step_rad = turn * step_rad;
    scan_.max_range_m = std::min<double>(scan.maxRange, filter_.max_range_m);
    scan_.pose_vehicle_laser = {mount.x(), mount.y(), mount.yaw()};
    ranges_m_.resize(beams);
    for (std::size_t i = 0; i < beams; ++i)
    {
        const float range_m = scan.getScanRange(i);
        const bool means_something = scan.getScanRangeValidity(i) &&
                                     range_m >= filter_.min_range_m &&
                                     range_m <= filter_.max_range_m;
        const double bearing_rad = first_rad + static_cast<double>(i) * step_rad;
        ranges_m_[i] = means_something && !mask_.contains(bearing_rad) ? range_m : 0;
    }
    scan_.ranges_m = ranges_m_.data();
    scan_.beams = beams;
    return scan_;
}

MapPose GuardFeed::poseOf(const ScanReport& report, double pose_s)
{
    MapPose pose;
    pose.stamp_s = pose_s;
    pose.pose_map_vehicle = report.pose_map_vehicle;
    const auto& c = report.covariance;
    // The larger eigenvalue of the position's part.
    const double mean = (c(0, 0) + c(1, 1)) / 2, half = (c(0, 0) - c(1, 1)) / 2;
    pose.sigma_m = std::sqrt(std::max(0.0, mean + std::hypot(half, c(0, 1))));
    pose.is_lost = is_lost(report.state);
    return pose;
}

void GuardFeed::add(const MapPose& pose)
{
    before_last_ = last_;
    last_ = pose;
}

std::optional<VehicleMotion> GuardFeed::motion(double now_s) const
{
    const double step_s = last_.stamp_s - before_last_.stamp_s;
    const bool is_known = !last_.is_lost && !before_last_.is_lost && step_s > 0 &&
                          step_s < kLongestStep_s && now_s - last_.stamp_s < kLongestStep_s;
    if (!is_known) return std::nullopt;
    const Pose2 step = between(before_last_.pose_map_vehicle, last_.pose_map_vehicle);
    VehicleMotion motion;
    motion.yaw_rate_radps = step.yaw / step_s;
    // The step is seen from before it; half of the turn leads to its middle, the other to its end.
    const double c = std::cos(step.yaw / 2), s = std::sin(step.yaw / 2);
    motion.velocity_vehicle = {
        (c * step.x + s * step.y) / step_s, (c * step.y - s * step.x) / step_s};
    return motion;
}
}  // namespace rtob

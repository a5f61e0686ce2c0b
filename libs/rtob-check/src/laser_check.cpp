// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/laser_check.h>
#include <rtob/map/conversions.h>

#include <cmath>

namespace rtob
{
namespace
{
constexpr int kBeamsMatched = 180;  // more cost time and tell no more of a step

ScanFilterOptions thinned(ScanFilterOptions options)
{
    options.max_beams = kBeamsMatched;
    return options;
}
}  // namespace

void LaserCheck::add(const mrpt::obs::CObservation2DRangeScan& scan)
{
    const double stamp_s = stamp_of(scan);
    stamps_.add(stamp_s);
    grid_.add(stamp_s);
    geometry_.add(scan);
    ranges_.add(scan);
    body_.add(scan);
}

void LaserCheck::report(CheckReport& report) const
{
    stamps_.report(report);
    grid_.report(report);
    geometry_.report(report);
    ranges_.report(report);
    body_.report(report);
}

ScanFilterOptions LaserCheck::filterOptions() const
{
    ScanFilterOptions options;
    options.max_range_m = ranges_.usefulRange();
    options.mask_deg = body_.mask();
    return options;
}

MotionCheck::MotionCheck(const ScanFilterOptions& filter, double usual_interval_s)
    : usual_interval_s_(usual_interval_s), filter_(thinned(filter)), sectors_(filter.max_range_m)
{
}

double MotionCheck::intervalTo(double stamp_s)
{
    if (!std::isfinite(stamp_s)) return usual_interval_s_;
    const double interval_s = last_stamp_s_ ? stamp_s - *last_stamp_s_ : 0;
    last_stamp_s_ = stamp_s;
    return interval_s < 0 ? usual_interval_s_ : interval_s;
}

void MotionCheck::add(
    const mrpt::obs::CObservation2DRangeScan& scan, const std::optional<Pose2>& pose_odom_vehicle)
{
    sectors_.add(scan);
    const auto& mount = scan.sensorPose;
    pose_vehicle_laser_ = {mount.x(), mount.y(), mount.yaw()};
    static_cast<void>(filter_.filter(scan, mount, points_vehicle_));
    std::optional<Pose2> odometry_step;
    if (pose_odom_vehicle && last_odometry_)
        odometry_step = between(*last_odometry_, *pose_odom_vehicle);
    last_odometry_ = pose_odom_vehicle;
    const LaserStep step = laser_odometry_.add(points_vehicle_, odometry_step);
    odometry_.add(step, odometry_step);
    rest_.add(intervalTo(stamp_of(scan)), step, odometry_step);
}

void MotionCheck::report(CheckReport& report) const
{
    sectors_.report(report);
    rest_.report(report);
    odometry_.report(report, pose_vehicle_laser_, usual_interval_s_);
}
}  // namespace rtob

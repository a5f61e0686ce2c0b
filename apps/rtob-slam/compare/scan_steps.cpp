// SPDX-License-Identifier: BSD-3-Clause
#include "compare/scan_steps.h"

#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/map/conversions.h>

#include <cmath>
#include <limits>

namespace rtob
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
}  // namespace

ScanSteps::ScanSteps(const std::string& log, const RunConfig& config, const RunLimits& limits)
    : log_(open_log(log)),
      limits_(limits),
      filter_(config.slam.scan_filter),
      mask_(config.slam.scan_filter.mask_deg),
      sensor_(config.slam.sensor)
{
}

std::optional<ScanStep> ScanSteps::next()
{
    while (read_.end == RunEnd::LogEnd && read_.scans < limits_.first_scans) try
        {
            const auto entry = log_->next();
            if (!entry) return {};
            const auto scan =
                std::dynamic_pointer_cast<CObservation2DRangeScan>(entry->observation);
            if (!scan)
                takeOdometry(*entry);
            else if (auto step = takeScan(scan))
                return step;
        }
        catch (const LogError& error)
        {
            read_.end = RunEnd::DamagedLog;
            read_.damage = error.what();
        }
    return {};
}

void ScanSteps::takeOdometry(const LogEntry& entry)
{
    const auto* odometry = dynamic_cast<const CObservationOdometry*>(entry.observation.get());
    if (!entry.motion) ++read_.other_observations;
    if (skipping() || !limits_.use_odometry) return;
    Pose2 pose_odom_vehicle = pose_odom_vehicle_.value_or(Pose2{});
    if (entry.motion)
        pose_odom_vehicle =
            compose(pose_odom_vehicle, to_pose2(entry.motion->poseChange->getMeanVal()));
    else if (odometry)
        pose_odom_vehicle = to_pose2(odometry->odometry);
    else
        return;
    if (!is_finite(pose_odom_vehicle)) return;
    pose_odom_vehicle_ = pose_odom_vehicle;
    odometry_is_new_ = true;
}

std::optional<ScanStep> ScanSteps::takeScan(const CObservation2DRangeScan::Ptr& scan)
{
    if (!sensor_.uses(*scan))
    {
        ++read_.scans_of_other_lasers;
        read_.other_labels.insert(scan->sensorLabel);
        return {};
    }
    if (skipping())
    {
        ++read_.scans_skipped;
        return {};
    }
    ++read_.scans;
    prepare(*scan);
    const bool has_stamp = scan->timestamp != INVALID_TIMESTAMP;
    ScanStep step;
    step.time_s = clock_.advance(
        has_stamp ? mrpt::Clock::toDouble(scan->timestamp)
                  : std::numeric_limits<double>::quiet_NaN());
    step.scan = scan;
    if (odometry_is_new_) step.pose_odom_vehicle = pose_odom_vehicle_;
    odometry_is_new_ = false;
    return step;
}

void ScanSteps::prepare(CObservation2DRangeScan& scan) const
{
    scan.setSensorPose(sensor_.mountOf(scan));
    for (std::size_t i = 0; i < scan.getScanSize(); ++i)
    {
        const float range_m = scan.getScanRange(i);
        const bool is_usable = std::isfinite(range_m) && range_m > 0 &&
                               range_m >= filter_.min_range_m && range_m <= filter_.max_range_m &&
                               !mask_.contains(scan.getScanAngle(i));
        if (!is_usable) scan.setScanRangeValidity(i, false);
    }
}
}  // namespace rtob

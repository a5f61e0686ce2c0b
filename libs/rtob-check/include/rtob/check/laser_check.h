// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/check/body_check.h>
#include <rtob/check/geometry_check.h>
#include <rtob/check/laser_odometry.h>
#include <rtob/check/odometry_check.h>
#include <rtob/check/range_check.h>
#include <rtob/check/rest_check.h>
#include <rtob/check/sector_check.h>
#include <rtob/check/stamp_check.h>
#include <rtob/check/stamp_grid.h>
#include <rtob/slam/scan_filter.h>

#include <optional>

namespace rtob
{
/// What one laser's scans hold, each for itself.
class LaserCheck
{
 public:
    void add(const mrpt::obs::CObservation2DRangeScan& scan);
    void report(CheckReport& report) const;

    /// To read the scans rightly, with what was learned of them.
    [[nodiscard]] ScanFilterOptions filterOptions() const;
    [[nodiscard]] double usualInterval() const { return stamps_.usualInterval(); }

 private:
    StampCheck stamps_;
    StampGrid grid_;
    GeometryCheck geometry_;
    RangeCheck ranges_;
    BodyCheck body_;
};

/// What one laser's scans tell together: how the vehicle moves. For a second reading of the log.
class MotionCheck
{
 public:
    MotionCheck(const ScanFilterOptions& filter, double usual_interval_s);
    /// @param pose_odom_vehicle the latest odometry; nothing where there is none
    void add(
        const mrpt::obs::CObservation2DRangeScan& scan,
        const std::optional<Pose2>& pose_odom_vehicle);
    void report(CheckReport& report) const;

 private:
    [[nodiscard]] double intervalTo(double stamp_s);

    double usual_interval_s_;
    ScanFilter filter_;
    SectorCheck sectors_;
    LaserOdometry laser_odometry_;
    OdometryCheck odometry_;
    RestCheck rest_;
    Points points_vehicle_;
    Pose2 pose_vehicle_laser_;
    std::optional<Pose2> last_odometry_;
    std::optional<double> last_stamp_s_;
};
}  // namespace rtob

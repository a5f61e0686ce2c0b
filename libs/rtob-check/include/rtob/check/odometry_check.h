// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/check/check_report.h>
#include <rtob/check/laser_odometry.h>
#include <rtob/check/motion_steps.h>

#include <optional>

namespace rtob
{
/// The vehicle's odometry against the laser's own: time, sign, scale, heading, reverse, mount.
class OdometryCheck
{
 public:
    /// The motion since the scan before; nothing where the log has no odometry (yet).
    void add(const LaserStep& laser, const std::optional<Pose2>& odometry_step);

    /// @param pose_vehicle_laser as the log has it
    /// @param interval_s between two scans
    void report(CheckReport& report, const Pose2& pose_vehicle_laser, double interval_s) const;

 private:
    void reportSource(CheckReport& report) const;
    void reportSpacing(CheckReport& report) const;
    void judge(CheckReport& report, const Pose2& pose_vehicle_laser, double interval_s) const;

    MotionSteps steps_;
    std::uint64_t scans_ = 0, with_odometry_ = 0, measured_ = 0;
    double laser_path_m_ = 0, laser_turn_rad_ = 0, odometry_path_m_ = 0, odometry_turn_rad_ = 0;
};
}  // namespace rtob

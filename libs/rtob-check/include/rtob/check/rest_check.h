// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/check/check_report.h>
#include <rtob/check/laser_odometry.h>

#include <cstdint>
#include <optional>

namespace rtob
{
/// When the vehicle stands, as the laser sees it, and what its odometry says meanwhile.
class RestCheck
{
 public:
    /// @param interval_s since the scan before
    void add(
        double interval_s, const LaserStep& laser_step, const std::optional<Pose2>& odometry_step);
    void report(CheckReport& report) const;

 private:
    void endPeriod();

    Pose2 pose_start_now_, odometry_start_now_;  ///< since the current period began
    double period_s_ = 0;
    std::uint64_t period_scans_ = 0;

    std::uint64_t periods_ = 0;
    double all_s_ = 0, rest_s_ = 0, longest_s_ = 0;
    std::uint64_t slips_ = 0;  ///< periods in which the odometry moved
    double worst_slip_m_ = 0, worst_slip_rad_ = 0;
};
}  // namespace rtob

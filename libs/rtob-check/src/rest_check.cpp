// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/rest_check.h>

#include <algorithm>
#include <cmath>

#include "figures.h"

namespace rtob
{
namespace
{
constexpr double kRest_m = 0.03, kRest_rad = 0.02;  // what the laser's noise may feign
constexpr double kShortest_s = 2;
constexpr std::uint64_t kFewestScans = 5;
constexpr double kSlip_m = 0.1, kSlip_rad = 0.1;  // an odometry at rest keeps below
constexpr double kLongestInterval_s = 10;         // longer: a gap, not a rest
}  // namespace

void RestCheck::add(
    double interval_s, const LaserStep& laser_step, const std::optional<Pose2>& odometry_step)
{
    const bool is_continuous = interval_s >= 0 && interval_s < kLongestInterval_s;
    if (is_continuous) all_s_ += interval_s;
    const Pose2 moved = compose(pose_start_now_, laser_step.pose_prev_now);
    const bool rests = laser_step.is_measured && is_continuous &&
                       std::hypot(moved.x, moved.y) < kRest_m && std::abs(moved.yaw) < kRest_rad;
    if (!rests)
    {
        endPeriod();
        return;
    }
    pose_start_now_ = moved;
    if (odometry_step) odometry_start_now_ = compose(odometry_start_now_, *odometry_step);
    period_s_ += interval_s;
    ++period_scans_;
}

void RestCheck::endPeriod()
{
    if (period_s_ >= kShortest_s && period_scans_ >= kFewestScans)
    {
        ++periods_;
        rest_s_ += period_s_;
        longest_s_ = std::max(longest_s_, period_s_);
        const double slip_m = std::hypot(odometry_start_now_.x, odometry_start_now_.y);
        const double slip_rad = std::abs(odometry_start_now_.yaw);
        if (slip_m > kSlip_m || slip_rad > kSlip_rad) ++slips_;
        worst_slip_m_ = std::max(worst_slip_m_, slip_m);
        worst_slip_rad_ = std::max(worst_slip_rad_, slip_rad);
    }
    pose_start_now_ = odometry_start_now_ = {};
    period_s_ = 0;
    period_scans_ = 0;
}

void RestCheck::report(CheckReport& report) const
{
    RestCheck ended = *this;  // the log may end at rest
    ended.endPeriod();
    Finding finding;
    finding.id = "motion.rests";
    finding.values = {
        {"periods", static_cast<double>(ended.periods_)},
        {"rest_s", ended.rest_s_},
        {"longest_s", ended.longest_s_},
        {"log_s", all_s_},
        {"slips", static_cast<double>(ended.slips_)},
        {"worst_slip_m", ended.worst_slip_m_},
        {"worst_slip_deg", ended.worst_slip_rad_ * kRadToDeg}};
    finding.text = "the vehicle stands " + counted(ended.periods_, "time") + ", " +
                   fixed(ended.rest_s_, 0) + " s of " + fixed(all_s_, 0) + " s, at longest " +
                   fixed(ended.longest_s_, 0) + " s";
    if (ended.slips_ > 0)
    {
        finding.severity = Severity::Warn;
        finding.text += "; in " + std::to_string(ended.slips_) +
                        " of them the odometry moves, up to " + fixed(ended.worst_slip_m_, 2) +
                        " m and " + fixed(ended.worst_slip_rad_ * kRadToDeg, 0) + " deg";
        finding.fix = "Wheels that slip, a gyro that drifts, or odometry that arrives late";
    }
    report.findings.push_back(std::move(finding));
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/odometry_check.h>

#include <cmath>

#include "figures.h"
#include "odometry_findings.h"

namespace rtob
{
namespace
{
constexpr std::size_t kMostSteps = 200'000;  // 11 MB; half a day of driving at 5 Hz
constexpr double kMoves_m = 1, kMoves_rad = 1;
constexpr double kStandsShare = 0.02;  // of the laser's motion: this odometry is none
constexpr double kFarApart_m = 0.5;
constexpr double kSeenShare = 0.9;
constexpr double kSlowestMotion_m = 0.02;  // less a scan counts as standing
}  // namespace

void OdometryCheck::add(const LaserStep& laser, const std::optional<Pose2>& odometry_step)
{
    ++scans_;
    if (laser.is_measured)
    {
        ++measured_;
        laser_path_m_ += std::hypot(laser.pose_prev_now.x, laser.pose_prev_now.y);
        laser_turn_rad_ += std::abs(laser.pose_prev_now.yaw);
    }
    if (odometry_step)
    {
        ++with_odometry_;
        odometry_path_m_ += std::hypot(odometry_step->x, odometry_step->y);
        odometry_turn_rad_ += std::abs(odometry_step->yaw);
    }
    if (steps_.size() < kMostSteps)
        steps_.push_back(
            {laser.pose_prev_now, odometry_step.value_or(Pose2{}), laser.is_measured,
             laser.holds_position});
}

void OdometryCheck::report(
    CheckReport& report, const Pose2& pose_vehicle_laser, double interval_s) const
{
    reportSpacing(report);
    reportSource(report);
    const bool moves = odometry_path_m_ > kStandsShare * laser_path_m_ ||
                       odometry_turn_rad_ > kStandsShare * laser_turn_rad_;
    if (with_odometry_ > 0 && moves) judge(report, pose_vehicle_laser, interval_s);
}

/// How well the laser alone follows the vehicle, and how far apart its scans are.
void OdometryCheck::reportSpacing(CheckReport& report) const
{
    std::uint64_t moving = 0;
    double path_m = 0;
    for (const auto& step : steps_)
    {
        const double step_m = std::hypot(step.laser.x, step.laser.y);
        if (!step.is_measured || step_m < kSlowestMotion_m) continue;
        ++moving;
        path_m += step_m;
    }
    const double spacing_m = moving == 0 ? 0 : path_m / static_cast<double>(moving);
    const double seen = scans_ < 2 ? 1 : share_of(measured_, scans_ - 1);
    Finding finding;
    finding.id = "motion.spacing";
    finding.values = {
        {"spacing_m", spacing_m}, {"laser_path_m", laser_path_m_}, {"matched_share", seen}};
    finding.text = percent(seen) + " of the scans fit the scans before, " +
                   fixed(laser_path_m_, 1) + " m of path, " + fixed(spacing_m, 2) +
                   " m between scans while it moves";
    if (seen < kSeenShare)
    {
        finding.severity = Severity::Warn;
        finding.fix =
            "Scans do not overlap: too fast for the rate, ranges that err by decimetres, wrong "
            "angles of the beams, a "
            "tilting laser, or an empty place";
    }
    else if (spacing_m > kFarApart_m)
    {
        finding.severity = Severity::Warn;
        finding.fix =
            "These are key scans, not the laser's stream: narrow places and turns are "
            "missing. Log every scan where you can";
    }
    report.findings.push_back(std::move(finding));
}

void OdometryCheck::reportSource(CheckReport& report) const
{
    Finding finding;
    finding.id = "odometry.source";
    finding.values = {
        {"odometry_path_m", odometry_path_m_},
        {"odometry_turn_deg", odometry_turn_rad_ * kRadToDeg},
        {"scans_with_odometry", static_cast<double>(with_odometry_)}};
    const bool laser_moves = laser_path_m_ > kMoves_m || laser_turn_rad_ > kMoves_rad;
    const bool odometry_moves = odometry_path_m_ > kStandsShare * laser_path_m_ ||
                                odometry_turn_rad_ > kStandsShare * laser_turn_rad_;
    if (with_odometry_ == 0)
    {
        finding.severity = Severity::Warn;
        finding.text = "the log has no odometry";
        finding.fix = "run takes the last motion to go on; quick turns need a fast laser then";
    }
    else if (laser_moves && !odometry_moves)
    {
        finding.severity = Severity::Fail;
        finding.text =
            "the odometry stands still while the laser moves " + fixed(laser_path_m_, 1) + " m";
        finding.fix = "Leave it aside, see the suggested .ini";
        report.suggestions.push_back(
            {"Run", "use_odometry", "false", "it stands still while the laser moves"});
    }
    else
        finding.text = "the odometry drives " + fixed(odometry_path_m_, 1) + " m and turns " +
                       fixed(odometry_turn_rad_ * kRadToDeg, 0) + " deg in all";
    report.findings.push_back(std::move(finding));
}

void OdometryCheck::judge(
    CheckReport& report, const Pose2& pose_vehicle_laser, double interval_s) const
{
    const auto shift = find_time_shift(steps_);
    report_time_shift(report, shift, interval_s);
    const TimeShift known = shift.value_or(TimeShift{});
    if (is_mirrored(known))
    {
        report_mirror(report, pose_vehicle_laser);
        return;
    }
    const MotionSteps steps = shifted(steps_, known);
    const auto turns = fit_turns(steps);
    const auto travel = fit_travel(steps);
    report_turns(report, turns);
    report_travel(report, travel);
    const auto heading = heading_errors(steps);
    report_heading(report, heading);
    report_reverse(report, count_reverse(steps));
    report_mount(report, find_mount_turn(steps), pose_vehicle_laser);
    report_origin(report, {known, turns, travel, heading, odometry_path_m_});
}
}  // namespace rtob

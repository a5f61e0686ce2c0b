// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/check/check_report.h>
#include <rtob/check/motion_steps.h>

/// What the comparison of odometry and laser means, in words: one finding each, nothing where the
/// drive was too short to tell.
namespace rtob
{
void report_time_shift(
    CheckReport& report, const std::optional<TimeShift>& shift, double interval_s);

[[nodiscard]] bool is_mirrored(const TimeShift& shift);
void report_mirror(CheckReport& report, const Pose2& pose_vehicle_laser);

void report_turns(CheckReport& report, const std::optional<TurnFit>& fit);
void report_travel(CheckReport& report, const std::optional<Estimate>& scale);
void report_heading(CheckReport& report, const std::optional<HeadingErrors>& errors);
void report_reverse(CheckReport& report, const ReverseDriving& reverse);
void report_mount(
    CheckReport& report, const std::optional<Estimate>& turn, const Pose2& pose_vehicle_laser);

struct OdometryFigures
{
    TimeShift shift;
    std::optional<TurnFit> turns;
    std::optional<Estimate> travel;
    std::optional<HeadingErrors> heading;
    double path_m = 0;
};
/// Whether the odometry is too good for wheels: a SLAM program's poses, or a simulator's.
void report_origin(CheckReport& report, const OdometryFigures& figures);
}  // namespace rtob

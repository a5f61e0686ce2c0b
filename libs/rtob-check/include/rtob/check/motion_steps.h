// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <cstdint>
#include <optional>
#include <vector>

/// Two witnesses of one drive, scan by scan, and what their comparison tells.
namespace rtob
{
/// The motion from one scan to the next, in the vehicle frame of the first.
struct MotionStep
{
    Pose2 laser, odometry;
    bool is_measured = false;     ///< by the laser
    bool holds_position = false;  ///< and its translation, too, in every direction
};
using MotionSteps = std::vector<MotionStep>;

/// How far the laser's account comes after the odometry's.
struct TimeShift
{
    double scans = 0;      ///< > 0: the laser shows a turn later than the odometry
    double sign = 1;       ///< -1: it turns the other way
    double agreement = 0;  ///< correlation of the two turns, [0, 1]
};
/// From the turns; nothing where there is too little turning to tell.
[[nodiscard]] std::optional<TimeShift> find_time_shift(const MotionSteps& steps);

/// The same drive with the odometry moved in time to where the laser is; shorter by a few steps.
[[nodiscard]] MotionSteps shifted(const MotionSteps& steps, const TimeShift& shift);

struct Estimate
{
    double value = 0, deviation = 0;  ///< standard deviation of the value
};

/// odometry turn = scale * laser turn + heading error of the path, robustly.
struct TurnFit
{
    Estimate scale;
    double drift_rad_per_m = 0;  ///< the odometry's, steady over the path
};
[[nodiscard]] std::optional<TurnFit> fit_turns(const MotionSteps& steps);

/// odometry travel = scale * laser travel on straight stretches.
[[nodiscard]] std::optional<Estimate> fit_travel(const MotionSteps& steps);

/// By how much the odometry's heading leaves the laser's over 10 m of path.
struct HeadingErrors
{
    double steady_rad = 0;  ///< median
    double random_rad = 0;  ///< median distance from that
    double worst_rad = 0;   ///< of the errors themselves
};
[[nodiscard]] std::optional<HeadingErrors> heading_errors(const MotionSteps& steps);

struct ReverseDriving
{
    std::uint64_t laser = 0;          ///< steps back as the laser sees them
    std::uint64_t odometry = 0;       ///< of these, seen as steps back by the odometry
    std::uint64_t odometry_ever = 0;  ///< steps back by the odometry in the whole log
    std::uint64_t forward = 0;        ///< and as steps ahead
    double forward_m = 0;             ///< length of the latter, by the laser
};
[[nodiscard]] ReverseDriving count_reverse(const MotionSteps& steps);

/// Where the laser looks by the directions of travel: turn to be added to its mount.
[[nodiscard]] std::optional<Estimate> find_mount_turn(const MotionSteps& steps);
}  // namespace rtob

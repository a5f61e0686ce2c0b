// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <rtob/io/log_reader.h>
#include <rtob/io/no_return.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rtob
{
/// What one laser of a log looks like.
struct LaserContents
{
    std::string label;
    std::uint64_t scans = 0;
    mrpt::poses::CPose3D pose_vehicle_laser;  ///< of its first scan
    double mount_shift_m = 0;                 ///< the farthest that the mount was from that
    double mount_turn_rad = 0;
    NoReturnFinder no_return;  ///< of the scans without a maximum range
};

/// What a log holds, found by reading it once. Needed before the first line can be written.
struct LogContents
{
    std::vector<LaserContents> lasers;                 ///< in order of appearance
    std::map<std::string, std::uint64_t> odometry;     ///< by label
    std::map<std::string, std::uint64_t> robot_poses;  ///< by label
    std::map<std::string, std::uint64_t> others;       ///< by class, e.g. "CObservationIMU"
    std::uint64_t motions = 0;
    std::optional<Pose2> first_pose_odom_vehicle;
    std::string damage;  ///< the reader's message, where the log cannot be read to its end

    [[nodiscard]] bool has_odometry() const { return motions > 0 || !odometry.empty(); }
};

/// A damaged log is described up to its damage.
[[nodiscard]] LogContents survey_log(LogReader& log);
}  // namespace rtob

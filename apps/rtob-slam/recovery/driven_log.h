// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/slam/slam.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace rtob
{
/// A scan of a log and where the finished map of a run over the whole log has it.
struct DrivenScan
{
    mrpt::obs::CObservation2DRangeScan::Ptr scan;
    double map_time_s = 0;
    Pose2 pose_map_vehicle;
};

/// A log, run once: its scans in order, and the map they made.
struct DrivenLog
{
    std::vector<DrivenScan> scans;  ///< those that were TRACKING
    RtobMap map;
    double step_s = 0.1;  ///< usual time from scan to scan
};

/// @throws std::runtime_error when the log has no scans
[[nodiscard]] DrivenLog drive_log(
    const std::string& log, const SlamOptions& options,
    std::uint64_t first_scans = std::numeric_limits<std::uint64_t>::max());

/// Scans of the map to leave out: all from begin to end.
struct TimeSpan
{
    double begin_s = 0, end_s = 0;
};

/// The map without the scans of these times.
[[nodiscard]] RtobMap map_without(const RtobMap& map, const std::vector<TimeSpan>& left_out);
}  // namespace rtob

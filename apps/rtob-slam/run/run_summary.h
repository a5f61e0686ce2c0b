// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/map_clock.h>

#include <string>
#include <vector>

#include "run/guard_replay.h"
#include "run/offline_run.h"
#include "run/run_counters.h"
#include "run/run_options.h"
#include "run/sensor_figures.h"

namespace rtob
{
/// All that the summary tells.
struct RunSummary
{
    std::string log, config_file;
    RunConfig config;
    RunLimits limits;
    OfflineRun run;
    RunCounters counters;
    std::optional<GuardCounts> guard;
    MapClock::Anomalies clock;
    TrackingState final_state = TrackingState::Init;
    bool has_odometry = false;
    std::vector<SensorFigures> sensors;
    std::size_t map_points = 0, map_scans = 0, map_bytes = 0;
    std::string map_checksum, map_checksum_before;  ///< before: of a map from a file
    double map_resolution_m = 0;
    double matching_s = 0;          ///< wall time from the first entry to the last
    double total_s = 0;             ///< the same with the writing of the map
    double matching_memory_mb = 0;  ///< the process's peak until the last scan
    double memory_mb = 0;           ///< the process's peak
};

/// A line that a person can quote: scans, lost, ms, memory, path, run time.
[[nodiscard]] std::string quotable_line(const RunSummary& summary);

/// summary.txt and summary.json: the same figures.
[[nodiscard]] std::string summary_text(const RunSummary& summary);
[[nodiscard]] std::string summary_json(const RunSummary& summary);

/// "--first", "the log's end" ...: how a run ended.
[[nodiscard]] std::string end_text(const OfflineRun& run);
}  // namespace rtob

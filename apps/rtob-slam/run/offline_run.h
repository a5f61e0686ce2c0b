// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/io/log_reader.h>
#include <rtob/slam/slam.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <string>

namespace rtob
{
struct RunLimits
{
    std::uint64_t skip_scans = 0;
    std::uint64_t first_scans = std::numeric_limits<std::uint64_t>::max();
    bool use_odometry = true;
};

/// Why a run is over.
enum class RunEnd
{
    LogEnd,
    Limit,      ///< as many scans as asked
    Stopped,    ///< someone wanted it to end
    DamagedLog  ///< the log cannot be read on
};

/// What a log held and how the run ended.
struct OfflineRun
{
    RunEnd end = RunEnd::LogEnd;
    std::string damage;  ///< the reader's message after DamagedLog
    std::uint64_t scans = 0, scans_skipped = 0, scans_of_other_lasers = 0, other_observations = 0;
    std::uint64_t dropped_live = 0;      ///< by the live program that wrote the log
    std::set<std::string> other_labels;  ///< of lasers that were not chosen; a few
};

using ScanDone = std::function<void(const mrpt::obs::CObservation2DRangeScan&, const ScanReport&)>;

/// Gives a log to the pipeline, an entry at a time; `done` hears of each scan, and the run ends
/// early when `stop` says so. Errors other than the log's pass through.
[[nodiscard]] OfflineRun run_log(
    LogReader& log, Slam& slam, const RunLimits& limits, const ScanDone& done,
    const std::function<bool()>& stop);

/// Says why a run saw no scan, and what to do.
[[nodiscard]] std::string no_scans_message(const std::string& log, const OfflineRun& run);
}  // namespace rtob

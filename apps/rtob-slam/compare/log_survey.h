// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <string>
#include <vector>

#include "run/offline_run.h"
#include "run/run_options.h"

namespace rtob
{
/// What a comparison must know of a log before it starts the programs.
struct LogSurvey
{
    std::vector<StampedPose2> scans;  ///< a pose at the origin for each, at its stamp
    double duration_s = 0;            ///< map time of the last scan
    bool has_odometry = false;
    std::uint64_t stamps_back = 0;
    OfflineRun read;
};

/// Throws LogError, or std::runtime_error when the log holds no scan to use.
[[nodiscard]] LogSurvey survey_log(
    const std::string& log, const RunConfig& config, const RunLimits& limits);
}  // namespace rtob

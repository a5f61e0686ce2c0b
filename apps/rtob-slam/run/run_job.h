// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "run/guard_replay.h"
#include "run/progress_line.h"
#include "run/run_summary.h"

namespace rtob
{
/// What `rtob-slam run` is asked to do.
struct RunJob
{
    std::string log, config_file;
    std::string folder;  ///< of the results
    bool may_overwrite = false;
    bool wants_simple_map = false;
    RunLimits limits;
    RunConfig config;
    std::optional<GuardWish> guard_wish;  ///< replay the guard, too
};

/// Runs the pipeline over the log and writes the folder of results. A run that ends early writes
/// what there is; the summary's `run` says how it ended. Throws std::runtime_error, and leaves no
/// folder, when not even one scan was there.
[[nodiscard]] RunSummary do_run(
    const RunJob& job, ProgressLine& progress, const std::function<bool()>& stop);
}  // namespace rtob

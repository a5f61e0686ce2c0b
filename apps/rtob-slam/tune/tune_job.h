// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tune/tune_figures.h"

namespace rtob
{
/// What `rtob-slam tune` is asked to do.
struct TuneJob
{
    std::string source;  ///< a log, or a world to fly
    std::string truth;   ///< of a log
    std::string folder;
    bool may_overwrite = false;
    double budget_ms = 20;
    int seeds = 3;
    std::uint64_t first_scans = 0;  ///< 0: all
    RunConfig config;               ///< what the tuning starts from
};

struct TuneResult
{
    std::vector<TuneCurve> curves;
    RunConfig suggested;
    TuneFigures before, after;
};

/// Measures every sweep, chooses, measures what was chosen, and writes tune.ini, tune.md and a
/// plot a sweep. `progress` is told what is being done. Throws std::runtime_error.
TuneResult tune(const TuneJob& job, const std::function<void(const std::string&)>& progress);

/// What tune.md holds.
[[nodiscard]] std::string tuning_text(const TuneJob& job, const TuneResult& result);
/// Accuracy and time over the values of one sweep, as SVG.
[[nodiscard]] std::string tuning_plot(const TuneCurve& curve, double budget_ms);
/// What differs from the defaults.
[[nodiscard]] std::string tuning_ini(const TuneJob& job, const TuneResult& result);
}  // namespace rtob

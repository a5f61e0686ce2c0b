// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <rtob/io/log_reader.h>

#include <functional>
#include <string>
#include <vector>

#include "tune/tune_figures.h"

namespace rtob
{
/// A log in memory, with its truth.
struct TuneFlight
{
    std::vector<LogEntry> entries;
    std::vector<StampedPose2> truth;
};

/// Reads a log up to so many scans (0: all). Throws LogError.
[[nodiscard]] TuneFlight read_flight(
    const std::string& log, const std::string& truth, std::uint64_t first_scans, bool odometry);

/// Runs settings over the flights: seed i on flight i, in turn where there are fewer flights.
class TuneRuns
{
 public:
    /// `done` is told after each run how many of how many are over; from any thread, one at a time.
    using Done = std::function<void(std::size_t, std::size_t)>;

    TuneRuns(std::vector<TuneFlight> flights, int seeds, Done done);

    /// How accurate each setting is, on all cores.
    void measureAccuracy(
        const std::vector<RunConfig>& settings, std::vector<TuneFigures>& figures) const;
    /// How long each setting takes, one run after the other and nothing beside.
    void measureTime(
        const std::vector<RunConfig>& settings, std::vector<TuneFigures>& figures) const;

 private:
    struct OneRun
    {
        double rmse_m = 0;
        std::uint64_t lost_scans = 0;
        std::vector<float> scan_ms;
    };
    [[nodiscard]] OneRun run(const RunConfig& setting, int seed) const;

    std::vector<TuneFlight> flights_;
    int seeds_;
    Done done_;
};
}  // namespace rtob

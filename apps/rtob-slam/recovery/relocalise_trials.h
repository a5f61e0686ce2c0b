// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "recovery/driven_log.h"

namespace rtob
{
struct RelocaliseTrials
{
    std::uint64_t count = 100, seed = 1;
    int most_scans = 10;    ///< that a trial may look at: 1 s of an RPLidar
    double left_out_s = 2;  ///< before the first and after the last of them
    double right_m = 0.2, right_deg = 5;
};

enum class Outcome
{
    Right,   ///< found where it was
    Wrong,   ///< believed to be elsewhere
    Nowhere  ///< not found within the scans
};

struct RelocaliseTrial
{
    std::size_t scan = 0;  ///< of the driven log
    Outcome outcome = Outcome::Nowhere;
    int scans = 0;  ///< looked at
    double error_m = 0, error_deg = 0;
    /// Of a trial that is not right: the least share of a scan's points that the map explains where
    /// the scan was taken, [0, 1]. It is small where nothing else has seen what the scan shows.
    double explained_at_truth = 1;
    double total_ms =
        0;  ///< of the processor, for all scans looked at, the drawing of the map apart
    double worst_ms = 0;  ///< the same, of one
    double map_ms = 0;    ///< to draw the map, once a map
};

/// Wakes a vehicle up at random scans of the log, in the map without these scans, and without
/// odometry.
[[nodiscard]] std::vector<RelocaliseTrial> relocalise_trials(
    const DrivenLog& driven, const SlamOptions& options, const RelocaliseTrials& trials);
}  // namespace rtob

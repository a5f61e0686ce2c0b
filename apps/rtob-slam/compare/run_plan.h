// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "compare/variant_job.h"

namespace rtob
{
struct PlannedRun
{
    std::size_t variant = 0;  ///< index into the list
    std::uint64_t seed = 1;
    int round = 1;
};

/// In which order the variants run. A round runs each of them once, every other round backwards, so
/// that a slow moment of the machine does not hit the same one always. There are max(repeats,
/// seeds) rounds; those beyond `repeats` are for RTOB-SLAM alone, whose worst seed is judged by the
/// others' few runs. What draws at random takes the seeds 1 to `seeds` in turn.
[[nodiscard]] std::vector<PlannedRun> plan_runs(
    const std::vector<VariantSpec>& variants, int repeats, int seeds);
}  // namespace rtob

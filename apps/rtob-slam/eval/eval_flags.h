// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/eval/trajectory_score.h>

#include <string>
#include <vector>

namespace rtob
{
/// The flags of `eval` as typed; empty where not given.
struct EvalFlags
{
    std::string estimate, reference, folder;
    std::string align, max_difference, tolerance;
    std::vector<std::string> deltas;
    bool all_steps = false, steps_of_reference = false;
    bool json = false;

    /// Any that means nothing for relations; empty otherwise.
    [[nodiscard]] std::string trajectoryFlag() const;
};

/// Throws UsageError that names the flag.
[[nodiscard]] ScoreOptions score_options(const EvalFlags& flags);
}  // namespace rtob

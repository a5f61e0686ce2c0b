// SPDX-License-Identifier: BSD-3-Clause
#include "compare/run_plan.h"

#include <algorithm>

namespace rtob
{
std::vector<PlannedRun> plan_runs(const std::vector<VariantSpec>& variants, int repeats, int seeds)
{
    std::vector<PlannedRun> plan;
    for (int round = 1; round <= std::max(repeats, seeds); ++round)
    {
        const auto begin = static_cast<std::ptrdiff_t>(plan.size());
        for (std::size_t v = 0; v < variants.size(); ++v)
        {
            if (variants[v].kind != VariantKind::Rtob && round > repeats) continue;
            const auto seed =
                variants[v].usesSeed() ? static_cast<std::uint64_t>((round - 1) % seeds + 1) : 1;
            plan.push_back({v, seed, round});
        }
        if (round % 2 == 0) std::reverse(plan.begin() + begin, plan.end());
    }
    return plan;
}
}  // namespace rtob

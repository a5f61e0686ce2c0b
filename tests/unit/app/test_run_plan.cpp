// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "compare/run_plan.h"

namespace rtob::test
{
namespace
{
/// "0s1 1 | 1 0s2": the variants of each round, with the seed where it counts.
std::string text_of(const std::vector<PlannedRun>& plan, const std::vector<VariantSpec>& variants)
{
    std::string text;
    int round = 1;
    for (const auto& run : plan)
    {
        if (run.round != round) text += "|";
        round = run.round;
        text += std::to_string(run.variant);
        if (variants[run.variant].usesSeed()) text += "s" + std::to_string(run.seed);
        text += " ";
    }
    return text;
}

std::vector<VariantSpec> variants_of(const std::vector<VariantKind>& kinds)
{
    std::vector<VariantSpec> variants;
    for (const auto kind : kinds)
    {
        variants.emplace_back();
        variants.back().kind = kind;
    }
    return variants;
}

TEST(PlanRuns, EveryOtherRoundRunsBackwards)
{
    const auto variants = variants_of({VariantKind::Mrpt, VariantKind::Mrpt, VariantKind::Mrpt});
    EXPECT_EQ(text_of(plan_runs(variants, 3, 1), variants), "0 1 2 |2 1 0 |0 1 2 ");
}

TEST(PlanRuns, SeedsTakeTurns)
{
    const auto variants = variants_of({VariantKind::Rtob, VariantKind::Mrpt});
    EXPECT_EQ(text_of(plan_runs(variants, 3, 2), variants), "0s1 1 |1 0s2 |0s1 1 ");
}

TEST(PlanRuns, MoreSeedsThanRepeatsAreForRtobAlone)
{
    const auto variants = variants_of({VariantKind::Mrpt, VariantKind::Pcl, VariantKind::Rtob});
    EXPECT_EQ(text_of(plan_runs(variants, 1, 3), variants), "0 1s1 2s1 |2s2 |2s3 ");
    EXPECT_EQ(text_of(plan_runs(variants, 2, 3), variants), "0 1s1 2s1 |2s2 1s2 0 |2s3 ");
}
}  // namespace
}  // namespace rtob::test

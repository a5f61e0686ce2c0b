// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/eval/comparison.h>

#include "comparison_sample.h"

namespace rtob::test
{
namespace
{
TEST(FiguresOf, TakesEachFigureOverTheRuns)
{
    ComparedVariant variant;
    variant.runs = {run_of({1, 2, 3, 4}), run_of({2, 4, 6, 8}), run_of({3, 6, 9, 12})};
    const auto figures = figures_of(variant);
    EXPECT_EQ(figures.results, 3u);
    // Nearest rank: the second of four scans.
    EXPECT_EQ(figures.scan_p50_ms.lowest, 2);
    EXPECT_EQ(figures.scan_p50_ms.median, 4);
    EXPECT_EQ(figures.scan_p50_ms.highest, 6);
    EXPECT_EQ(figures.scan_max_ms.median, 8);
    EXPECT_DOUBLE_EQ(figures.cpu_s.median, 0.020);  // 2 + 4 + 6 + 8 ms
}

TEST(FiguresOf, ATenthOfTheScansIsTheirFirstAndTheirLast)
{
    std::vector<float> times_ms(20, 5.0f);
    times_ms[0] = 1;
    times_ms[1] = 2;
    times_ms[18] = 10;
    times_ms[19] = 30;
    ComparedVariant variant;
    variant.runs = {run_of(times_ms)};
    const auto figures = figures_of(variant);
    EXPECT_DOUBLE_EQ(figures.first_tenth_ms.median, 1.5);
    EXPECT_DOUBLE_EQ(figures.last_tenth_ms.median, 20);
}

TEST(FiguresOf, TheWorstRunHasTheLargestMeanError)
{
    ComparedVariant variant;
    variant.runs = {run_with_error(0.2), run_with_error(0.7), run_with_error(0.3)};
    const auto figures = figures_of(variant);
    EXPECT_EQ(figures.worst, &variant.runs[1]);
    EXPECT_DOUBLE_EQ(figures.distance_m.median, 0.3);
    EXPECT_DOUBLE_EQ(figures.distance_m.lowest, 0.2);
}

TEST(FiguresOf, WithoutTruthTheFirstResultStandsForTheRuns)
{
    ComparedVariant variant;
    variant.runs = {failed_run("no log"), run_of({1}), run_of({2})};
    EXPECT_EQ(figures_of(variant).worst, &variant.runs[1]);
}

TEST(FiguresOf, FailedRunsCountInNoFigure)
{
    ComparedVariant variant;
    variant.runs = {failed_run("first reason"), run_of({3, 3}), failed_run("second reason")};
    const auto figures = figures_of(variant);
    EXPECT_EQ(figures.results, 1u);
    EXPECT_EQ(figures.failures, 2u);
    EXPECT_EQ(figures.failure, "first reason");
    EXPECT_EQ(figures.scan_p50_ms.lowest, 3);
}

TEST(FiguresOf, AllRunsFailed)
{
    ComparedVariant variant;
    variant.runs = {failed_run("crashed")};
    const auto figures = figures_of(variant);
    EXPECT_EQ(figures.results, 0u);
    EXPECT_EQ(figures.worst, nullptr);
}
}  // namespace
}  // namespace rtob::test

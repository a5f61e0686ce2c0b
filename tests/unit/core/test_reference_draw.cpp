// SPDX-License-Identifier: BSD-3-Clause
// Edges and laws of a single draw; how densities are followed is in test_draw_densities.cpp.
#include <density_formula.h>
#include <gtest/gtest.h>
#include <test_map.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

using namespace rtob;
using rtob::test::TestMap;

namespace
{
DensityOptions density_options(Density density)
{
    DensityOptions options;
    options.density = density;
    options.forgetting_s = density == Density::Forgetting ? 30 : 0;
    return options;
}

Reference drawn(
    const TestMap& map, const DensityOptions& density, const DrawOptions& options,
    const Moment& now, const std::optional<Box>& gate = {}, std::uint64_t seed = 1)
{
    ReferenceDraw draw(options);
    Random random(seed);
    Reference reference;
    draw.draw(map.view(), TimeDensity(density), now, gate, random, reference);
    return reference;
}

/// 10 Hz; the scan's points alternate between x = 1 and x = -1, so that a gate may take half.
TestMap standing_map(int scans, std::uint32_t points)
{
    TestMap map;
    for (int k = 0; k < scans; ++k)
        map.add(
            0.1 * k, {0, 0, 0}, points,
            [](std::uint32_t i) { return std::pair(i % 2 == 0 ? 1.0f : -1.0f, 0.0f); });
    return map;
}

std::vector<std::uint64_t> all_indices(std::uint64_t count)
{
    std::vector<std::uint64_t> indices(count);
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
}

constexpr Density kAllDensities[] = {
    Density::Uniform, Density::Interval, Density::Window, Density::Forgetting, Density::Revisit};
constexpr DrawMode kBothModes[] = {DrawMode::Independent, DrawMode::Stratified};
const Box kRightHalf{0, -1, 2, 1};
}  // namespace

TEST(ReferenceDraw, AnEmptyMapGivesNothing)
{
    const TestMap map;
    for (const auto density : kAllDensities)
        for (const auto mode : kBothModes)
            EXPECT_EQ(drawn(map, density_options(density), {100, mode}, {}).points.size(), 0u);
}

TEST(ReferenceDraw, ASupportWithoutScansOrPointsGivesNothing)
{
    TestMap map = standing_map(100, 50);
    auto interval = density_options(Density::Interval);
    interval.interval_begin_s = 20;
    auto revisit = density_options(Density::Revisit);
    Moment before_all{10, 0, 0};
    before_all.scans_end = 0;
    TestMap pointless;
    for (int k = 0; k < 100; ++k) pointless.add(k, {0, 0, 0}, 0);
    for (const auto mode : kBothModes)
    {
        EXPECT_EQ(drawn(map, interval, {100, mode}, {30, 0, 0}).points.size(), 0u);
        EXPECT_EQ(drawn(map, revisit, {100, mode}, {10, 50, 0}).points.size(), 0u);
        EXPECT_EQ(drawn(map, revisit, {100, mode}, before_all).points.size(), 0u);
        EXPECT_EQ(drawn(pointless, revisit, {100, mode}, {99, 0, 0}).points.size(), 0u);
    }
}

TEST(ReferenceDraw, GivesEachPointOnceWhenTheSupportHoldsNoMore)
{
    const TestMap map = standing_map(10, 20);
    for (const auto density : kAllDensities)
        for (const auto mode : kBothModes)
            for (const int points : {200, 201, 5000})
                EXPECT_EQ(
                    drawn(map, density_options(density), {points, mode}, {1, 0, 0}).indices,
                    all_indices(200));
}

TEST(ReferenceDraw, GivesEachPointInsideTheGateOnceWhenThereAreNoMore)
{
    const TestMap map = standing_map(10, 20);
    for (const auto density : kAllDensities)
        for (const auto mode : kBothModes)
        {
            const auto reference =
                drawn(map, density_options(density), {100, mode}, {1, 0, 0}, kRightHalf);
            ASSERT_EQ(reference.indices.size(), 100u);
            for (std::uint64_t i = 0; i < 100; ++i) EXPECT_EQ(reference.indices[i], 2 * i);
        }
}

TEST(ReferenceDraw, GivesAsManyAsAskedAndOnlyFromTheGate)
{
    const TestMap map = standing_map(1000, 20);
    for (const auto density : kAllDensities)
        for (const auto mode : kBothModes)
        {
            const auto reference =
                drawn(map, density_options(density), {1000, mode}, {100, 0, 0}, kRightHalf);
            EXPECT_EQ(reference.indices.size(), 1000u);
            for (const float x : reference.points.x) ASSERT_EQ(x, 1.0f);
        }
}

TEST(ReferenceDraw, PointsAreSeenFromTheVehicle)
{
    TestMap map;
    map.add(0, {5000, 3000, 1}, 10, 5001.5f, 2998.0f);
    const auto reference = drawn(map, density_options(Density::Uniform), {10}, {0, 5000, 3000});
    EXPECT_EQ(reference.origin_x, 5000);
    EXPECT_EQ(reference.origin_y, 3000);
    EXPECT_EQ(reference.points.x, std::vector<float>(10, 1.5f));
    EXPECT_EQ(reference.points.y, std::vector<float>(10, -2.0f));
}

TEST(ReferenceDraw, OneSeedOneDraw)
{
    const TestMap map = standing_map(500, 50);
    for (const auto density : kAllDensities)
        for (const auto mode : kBothModes)
        {
            const auto options = density_options(density);
            const DrawOptions draw{1000, mode};
            const auto once = drawn(map, options, draw, {50, 0, 0}, kRightHalf, 7).indices;
            EXPECT_EQ(drawn(map, options, draw, {50, 0, 0}, kRightHalf, 7).indices, once);
            EXPECT_NE(drawn(map, options, draw, {50, 0, 0}, kRightHalf, 8).indices, once);
        }
}

TEST(ReferenceDraw, DrawsNoScanAtOrAfterTheEnd)
{
    const TestMap map = standing_map(100, 50);
    Moment now{10, 0, 0};
    now.scans_end = 60;
    for (const auto density : kAllDensities)
        for (const auto mode : kBothModes)
        {
            const auto reference = drawn(map, density_options(density), {500, mode}, now);
            EXPECT_EQ(reference.indices.size(), 500u);
            for (const auto point : reference.indices) ASSERT_LT(map.scans.scanOf(point), 60u);
        }
}

// exp(-age / forgetting_s) is 0 in a double after 745 forgetting_s; the place is still known.
TEST(ReferenceDraw, APlaceLeftLongAgoIsStillDrawn)
{
    TestMap map;
    for (int k = 0; k < 100; ++k) map.add(0.1 * k, {0, 0, 0}, 50);
    for (int k = 0; k < 100; ++k) map.add(1e5 + 0.1 * k, {100, 0, 0}, 50);
    auto options = density_options(Density::Revisit);
    options.forgetting_s = 60;
    for (const auto mode : kBothModes)
    {
        const auto reference = drawn(map, options, {1000, mode}, {1e5 + 10, 0, 0});
        EXPECT_EQ(reference.indices.size(), 1000u);
        for (const auto point : reference.indices) ASSERT_LT(point, 5000u);
    }
}

// The densities that are constant over their support: any run of points gets its share, cut up or
// down to whole points.
TEST(ReferenceDraw, StratifiedFlatDrawsShareOutExactly)
{
    TestMap map;
    Random random(3);
    for (int k = 0; k < 700; ++k)
        map.add(0.1 * k, {0, 0, 0}, static_cast<std::uint32_t>(random.below(40)));
    for (const auto density : {Density::Uniform, Density::Interval, Density::Window})
    {
        const auto reference = drawn(map, density_options(density), {3600}, {70, 0, 0});
        const std::uint64_t first =
            density == Density::Window ? map.scans.firstPoint(map.scans.firstScanSince(40)) : 0;
        const double step = static_cast<double>(map.scans.pointCount() - first) / 3600;
        ASSERT_EQ(reference.indices.size(), 3600u);
        for (std::size_t k = 0; k < 3600; ++k)
        {
            const double stratum = static_cast<double>(first) + step * static_cast<double>(k);
            ASSERT_GE(static_cast<double>(reference.indices[k] + 1), stratum) << k;
            ASSERT_LE(static_cast<double>(reference.indices[k]), stratum + step) << k;
        }
    }
}

// 512 strata of time, each looked at once: p(t) of a scan stands for the strata it touches, so a
// scan is off by at most two strata's points, and the sum of all p by a few percent.
TEST(ReferenceDraw, StratifiedDrawsAreWithinTheirStrata)
{
    TestMap map;  // scans wider than a stratum; the vehicle passes by the origin twice
    for (int k = 0; k < 200; ++k) map.add(0.25 * k, {10 * std::sin(0.06 * k), 0, 0}, 300);
    constexpr double kStrata = 512, kPoints = 3600, kSlack = 0.05;
    for (const auto density : {Density::Forgetting, Density::Revisit})
    {
        auto options = density_options(density);
        options.vicinity_m = 5;
        const Moment now{50, 0, 0};
        std::vector<double> p;
        for (std::size_t k = 0; k < map.scans.size(); ++k)
            p.push_back(test::density_formula(options, map.scans, now, map.scans.time(k)));
        const double sum = std::accumulate(p.begin(), p.end(), 0.0);
        for (std::uint64_t seed = 1; seed <= 20; ++seed)
        {
            std::vector<double> counts(p.size());
            for (const auto point : drawn(map, options, {int(kPoints)}, now, {}, seed).indices)
                ++counts[map.scans.scanOf(point)];
            for (std::size_t k = 0; k < p.size(); ++k)
            {
                const double expected = kPoints * p[k] / sum;
                // An average scan holds 512 / 200 strata; where p is small, strata are wider.
                const double stratum = kPoints / kStrata * std::max(1.0, p[k] / (sum / 200));
                ASSERT_NEAR(counts[k], expected, 1 + 2 * stratum + kSlack * expected)
                    << "scan " << k << ", seed " << seed;
            }
        }
    }
}

TEST(ReferenceDraw, StratifiedDrawsOfALargeMapKeepEachMinutesShare)
{
    const TestMap map = standing_map(36000, 10);  // an hour in one place, 70 scans a stratum
    for (const auto density : {Density::Uniform, Density::Revisit})
    {
        std::vector<double> counts(60);
        for (const auto point : drawn(map, density_options(density), {3600}, {3600, 0, 0}).indices)
            ++counts[map.scans.scanOf(point) / 600];
        // A minute holds 8.5 strata of 7 points and may win or lose those that lie across its two
        // ends; p is constant but for the hour's two ends.
        for (const double count : counts) EXPECT_NEAR(count, 60, 1 + 2 * 7.1);
    }
}

TEST(DrawOptions, RefusesTooFewPoints)
{
    EXPECT_NO_THROW(ReferenceDraw({10, DrawMode::Stratified}));
    EXPECT_THROW(ReferenceDraw({9, DrawMode::Stratified}), std::invalid_argument);
}

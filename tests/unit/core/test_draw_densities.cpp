// SPDX-License-Identifier: BSD-3-Clause
// Each density, alone and combined, drawn in both modes and counted against its formula.
#include <chi_square.h>
#include <density_formula.h>
#include <gtest/gtest.h>
#include <rtob/core/enum_names.h>
#include <test_map.h>

#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

using namespace rtob;
using rtob::test::chi_square_deviation;
using rtob::test::TestMap;

namespace
{
constexpr int kPoints = 400;
constexpr int kDraws = 150;
constexpr double kDeviations = 4;  // a chance of 3e-5 a test
const Moment kNow{130, 0.5, 0};

/// 400 scans over two minutes: irregular and repeated times, 1 to 60 points each, on a circle of
/// 10 m that comes by the origin four times. Points lie within 6 m.
TestMap irregular_map()
{
    Random random(11);
    TestMap map;
    double time_s = 0;
    for (int k = 0; k < 400; ++k)
    {
        if (random.below(4) != 0) time_s += 0.8 * random.uniform();
        const double turn_rad = time_s * 0.2;
        const Pose2 pose{10 - 10 * std::cos(turn_rad), 10 * std::sin(turn_rad), 0};
        const auto near = [&](double v)
        { return static_cast<float>(v + 12 * random.uniform() - 6); };
        map.add(
            time_s, pose, static_cast<std::uint32_t>(1 + random.below(60)),
            [&](std::uint32_t) { return std::pair(near(pose.x), near(pose.y)); });
    }
    return map;
}

DensityOptions options_of(Density density, bool forget)
{
    DensityOptions options;
    options.density = density;
    options.interval_begin_s = 20;
    options.interval_end_s = 90;
    options.window_s = 60;
    options.vicinity_m = 4;
    if (density == Density::Forgetting) options.forgetting_s = 40;
    if (forget) options.forgetting_s = 25;
    return options;
}

/// The exact share of each scan: p(its time) x its points inside the gate.
std::vector<double> scan_weights(
    const TestMap& map, const DensityOptions& options, const std::optional<Box>& gate)
{
    std::vector<double> weights;
    for (std::size_t k = 0; k < map.scans.size(); ++k)
    {
        double points = 0;
        for (auto i = map.scans.firstPoint(k); i < map.scans.firstPoint(k + 1); ++i)
            points += !gate || gate->contains(map.points_map.x[i], map.points_map.y[i]);
        weights.push_back(
            points * test::density_formula(options, map.scans, kNow, map.scans.time(k)));
    }
    return weights;
}

/// How often each scan is drawn, over kDraws draws.
std::vector<std::uint64_t> scan_counts(
    const TestMap& map, const DensityOptions& options, const std::optional<Box>& gate,
    DrawMode mode)
{
    std::vector<std::uint64_t> counts(map.scans.size());
    const TimeDensity density(options);
    ReferenceDraw draw({kPoints, mode});
    Random random(5);
    Reference reference;
    for (int i = 0; i < kDraws; ++i)
    {
        draw.draw(map.view(), density, kNow, gate, random, reference);
        EXPECT_EQ(reference.indices.size(), std::size_t{kPoints});
        for (const auto point : reference.indices) ++counts[map.scans.scanOf(point)];
    }
    return counts;
}

using Case = std::tuple<Density, bool, bool>;  // forgetting, gate

class DrawDensities : public testing::TestWithParam<Case>
{
 protected:
    const TestMap map_ = irregular_map();
    const DensityOptions options_ = options_of(std::get<0>(GetParam()), std::get<1>(GetParam()));
    const std::optional<Box> gate_ =
        std::get<2>(GetParam()) ? std::optional(Box::around(kNow.x, kNow.y, 9)) : std::nullopt;
};

std::string case_name(const testing::TestParamInfo<Case>& info)
{
    std::string name(name_of(std::get<0>(info.param)));
    if (std::get<1>(info.param)) name += "_x_forgetting";
    if (std::get<2>(info.param)) name += "_x_gate";
    return name;
}
}  // namespace

TEST_P(DrawDensities, IndependentDrawsFollowTheFormula)
{
    const auto counts = scan_counts(map_, options_, gate_, DrawMode::Independent);
    EXPECT_LT(chi_square_deviation(counts, scan_weights(map_, options_, gate_)), kDeviations);
}

// Strata make the counts vary less than independent draws, so the same limit holds.
TEST_P(DrawDensities, StratifiedDrawsFollowTheFormula)
{
    const auto counts = scan_counts(map_, options_, gate_, DrawMode::Stratified);
    EXPECT_LT(chi_square_deviation(counts, scan_weights(map_, options_, gate_)), kDeviations);
}

INSTANTIATE_TEST_SUITE_P(
    All, DrawDensities,
    testing::Combine(
        testing::Values(
            Density::Uniform, Density::Interval, Density::Window, Density::Forgetting,
            Density::Revisit),
        testing::Bool(), testing::Bool()),
    case_name);

// The negative control: formulas that are a little off do not pass.
TEST(DrawDensitiesControl, AWrongFormulaIsFound)
{
    const TestMap map = irregular_map();
    const auto revisit = options_of(Density::Revisit, false);
    const auto counts = scan_counts(map, revisit, {}, DrawMode::Independent);
    auto wider = revisit, farther = revisit, forgetting = revisit;
    wider.sigma_s = 1.15;
    farther.vicinity_m = 4.4;
    forgetting.forgetting_s = 500;
    for (const DensityOptions& wrong :
         {wider, farther, forgetting, options_of(Density::Uniform, false)})
        EXPECT_GT(chi_square_deviation(counts, scan_weights(map, wrong, {})), kDeviations);

    const auto window = options_of(Density::Window, false);
    auto shorter = window;
    shorter.window_s = 59;
    const auto window_counts = scan_counts(map, window, {}, DrawMode::Independent);
    EXPECT_GT(chi_square_deviation(window_counts, scan_weights(map, shorter, {})), kDeviations);
}

TEST(DrawDensitiesControl, AnIgnoredGateIsFound)
{
    const TestMap map = irregular_map();
    const auto uniform = options_of(Density::Uniform, false);
    const auto counts = scan_counts(map, uniform, {}, DrawMode::Independent);
    const Box gate = Box::around(kNow.x, kNow.y, 9);
    EXPECT_GT(chi_square_deviation(counts, scan_weights(map, uniform, gate)), kDeviations);
}

// All points of one scan have one time, so one chance.
TEST(DrawDensitiesControl, PointsOfAScanAreDrawnAlike)
{
    TestMap map;
    for (int k = 0; k < 50; ++k) map.add(0.1 * k, {0, 0, 0}, 60);
    for (const auto mode : {DrawMode::Independent, DrawMode::Stratified})
    {
        std::vector<std::uint64_t> counts(60);
        ReferenceDraw draw({kPoints, mode});
        Random random(2);
        Reference reference;
        for (int i = 0; i < kDraws; ++i)
        {
            draw.draw(
                map.view(), TimeDensity(options_of(Density::Revisit, true)), {5, 0, 0}, {}, random,
                reference);
            for (const auto point : reference.indices) ++counts[point % 60];
        }
        EXPECT_LT(chi_square_deviation(counts, std::vector<double>(60, 1.0)), kDeviations);
    }
}

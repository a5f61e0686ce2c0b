// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/map/options_io.h>

#include "tune/tune_figures.h"

namespace rtob
{
namespace
{
TunePoint point(const char* value, double worst_m, double p99_ms, std::uint64_t lost = 0)
{
    return {value, {worst_m, worst_m, lost, p99_ms / 2, p99_ms}};
}

TuneCurve curve(const char* section, const char* key, std::vector<TunePoint> points)
{
    return {{section, key, {}, ""}, "0.6", std::move(points)};
}

TEST(TuneFigures, OfPointsTheMostThatTheBudgetAllowsAreChosen)
{
    // Fewer are more accurate here: the paper takes the largest feasible number nevertheless.
    const auto points = curve(
        "Draw", "points",
        {point("600", 0.01, 5), point("1800", 0.02, 15), point("3600", 0.02, 30)});
    EXPECT_EQ(chosen_value(points, 20), "1800");
    EXPECT_EQ(chosen_value(points, 30), "3600");
    EXPECT_EQ(chosen_value(points, 2), "");
}

TEST(TuneFigures, ASettingThatLosesScansIsNotFeasible)
{
    const auto points = curve("Icp", "iterations", {point("8", 0.02, 5), point("16", 0.01, 6, 1)});
    EXPECT_EQ(chosen_value(points, 20), "8");
}

TEST(TuneFigures, OfOtherOptionsTheMostAccurateIsChosen)
{
    const auto distances = curve(
        "Icp", "max_pair_distance_m",
        {point("0.3", 0.010, 5), point("0.6", 0.020, 5), point("0.9", 0.005, 50)});
    EXPECT_EQ(chosen_value(distances, 20), "0.3");
}

TEST(TuneFigures, LessAccurateIsWhatTheMarginDoesNotExcuse)
{
    const auto off_by = [](double worst_m)
    {
        TuneFigures figures;
        figures.worst_m = worst_m;
        return figures;
    };
    EXPECT_FALSE(is_less_accurate(off_by(0.0104), off_by(0.0100)));  // 0.4 mm
    EXPECT_TRUE(is_less_accurate(off_by(0.0106), off_by(0.0100)));   // 0.6 mm, 6 %
    EXPECT_FALSE(is_less_accurate(off_by(0.104), off_by(0.100)));    // 4 %
    EXPECT_FALSE(is_less_accurate(off_by(0.005), off_by(0.010)));
}

TEST(TuneFigures, WhatIsAsGoodAsTheBestStaysAsItWas)
{
    const auto distances =
        curve("Icp", "max_pair_distance_m", {point("0.3", 0.0100, 5), point("0.6", 0.0104, 5)});
    EXPECT_EQ(chosen_value(distances, 20), "0.6");  // 0.4 mm apart
}

TEST(TunePlan, EverySettingIsValid)
{
    const RunConfig defaults = load_run_config("", {});
    for (const auto& sweep : tuning_sweeps())
        for (const auto& value : sweep.values)
        {
            const auto config = config_with(defaults, sweep, value);
            EXPECT_NO_THROW(config.slam.validate()) << sweep.name() << " = " << value;
            EXPECT_EQ(value_in(config, sweep), value) << sweep.name();
        }
}

TEST(TunePlan, AConstantComesWithItsDensity)
{
    const RunConfig defaults = load_run_config("", {});
    for (const auto& sweep : tuning_sweeps())
        if (sweep.key == "window_s")
        {
            EXPECT_EQ(config_with(defaults, sweep, "10").slam.density.density, Density::Window);
        }
}
}  // namespace
}  // namespace rtob

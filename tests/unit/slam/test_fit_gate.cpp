// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/fit_gate.h>

#include <stdexcept>

using rtob::FitGateOptions;
using rtob::FitVerdict;
using rtob::IcpResult;
using rtob::judge_fit;

namespace
{
/// A fit that passes every test of the default options.
IcpResult good_fit()
{
    IcpResult fit;
    fit.pairs = 300;
    fit.paired_share = 0.9;
    fit.known_share = 0.95;
    fit.mean_squared_error = 0.001;
    return fit;
}
}  // namespace

TEST(FitGate, AcceptsAGoodFit)
{
    EXPECT_EQ(judge_fit(good_fit(), {}), FitVerdict::Good);
}

TEST(FitGate, SaysWhenThereIsNothingToCompareWith)
{
    EXPECT_EQ(judge_fit(IcpResult(), {}), FitVerdict::None);
}

TEST(FitGate, RefusesALargeMeanSquaredError)
{
    const FitGateOptions options;
    IcpResult fit = good_fit();
    fit.mean_squared_error = options.max_mean_squared_error_m2;
    EXPECT_EQ(judge_fit(fit, options), FitVerdict::Good);
    fit.mean_squared_error *= 1.001;
    EXPECT_EQ(judge_fit(fit, options), FitVerdict::Weak);
}

TEST(FitGate, RefusesTooFewPairs)
{
    const FitGateOptions options;
    IcpResult fit = good_fit();
    fit.pairs = static_cast<std::size_t>(options.min_pairs);
    EXPECT_EQ(judge_fit(fit, options), FitVerdict::Good);
    --fit.pairs;
    EXPECT_EQ(judge_fit(fit, options), FitVerdict::Weak);
}

TEST(FitGate, TellsNewGroundFromAMismatch)
{
    const FitGateOptions options;
    IcpResult fit = good_fit();
    fit.paired_share = 0.99 * options.min_paired_share;
    fit.known_share = options.min_known_share;
    EXPECT_EQ(judge_fit(fit, options), FitVerdict::NewGround);
    fit.known_share *= 0.99;  // the map knows something there, and it is something else
    EXPECT_EQ(judge_fit(fit, options), FitVerdict::Weak);
}

TEST(FitGate, OnlyGoodAndNewGroundAreMatches)
{
    EXPECT_TRUE(is_match(FitVerdict::Good));
    EXPECT_TRUE(is_match(FitVerdict::NewGround));
    EXPECT_FALSE(is_match(FitVerdict::Weak));
    EXPECT_FALSE(is_match(FitVerdict::None));
}

TEST(FitGateOptions, RefusesValuesOutOfRange)
{
    const auto refuses = [](auto FitGateOptions::*key, auto value)
    {
        FitGateOptions options;
        options.*key = value;
        EXPECT_THROW(options.validate(), std::invalid_argument) << value;
    };
    refuses(&FitGateOptions::max_mean_squared_error_m2, 0.0);
    refuses(&FitGateOptions::min_paired_share, 0.0);
    refuses(&FitGateOptions::min_paired_share, 1.01);
    refuses(&FitGateOptions::min_known_share, 0.0);
    refuses(&FitGateOptions::min_known_share, 1.01);
    refuses(&FitGateOptions::min_pairs, 2);
    EXPECT_NO_THROW(FitGateOptions().validate());
}

TEST(FitGate, APointWithoutANeighbourCountsAsAFarOne)
{
    IcpResult fit = good_fit();
    fit.paired_share = 0.75;
    fit.mean_squared_error = 0.01;
    // Three quarters at 0.01 m^2, one quarter at (0.2 m)^2.
    EXPECT_NEAR(rtob::misfit_m2(fit, 0.2), 0.75 * 0.01 + 0.25 * 0.04, 1e-12);
    EXPECT_NEAR(rtob::misfit_m2(IcpResult(), 0.2), 0.04, 1e-12);
}

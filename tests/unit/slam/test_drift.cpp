// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/drift.h>

#include <stdexcept>

namespace
{
using rtob::Drift;
using rtob::DriftOptions;
using rtob::IcpResult;
using rtob::TravelLog;

/// One scan a metre, straight ahead.
TravelLog travelled(int metres)
{
    TravelLog travel;
    for (int i = 0; i <= metres; ++i) travel.inserted({1.0 * i, 0, 0});
    return travel;
}

IcpResult fit_with_information(double x, double y)
{
    IcpResult fit;
    fit.pairs = 100;
    fit.information.diagonal() << x, y, 100;
    return fit;
}

DriftOptions options()
{
    DriftOptions options;
    options.share = 0.03;
    options.trusted_m = 0.3;
    options.local_path_m = 20;
    return options;
}
}  // namespace

TEST(Drift, GrowsWithThePathSinceThePoseWasHeld)
{
    Drift drift(options());
    EXPECT_DOUBLE_EQ(drift.expected_m(travelled(50)), 1.5);
    drift.held(travelled(50), fit_with_information(50, 50));
    EXPECT_DOUBLE_EQ(drift.path_m(travelled(60)), 10);
    EXPECT_NEAR(drift.expected_m(travelled(60)), 0.3, 1e-12);
}

TEST(Drift, AFitThatLeavesADirectionOpenHoldsNothing)
{
    Drift drift(options());
    drift.held(travelled(50), fit_with_information(1, 99));
    EXPECT_DOUBLE_EQ(drift.path_m(travelled(60)), 60);
}

TEST(Drift, NamesTheDirectionThatAFitHolds)
{
    const Drift drift(options());
    EXPECT_FALSE(drift.onlyHeldDirection(fit_with_information(50, 50)).has_value());
    const auto held = drift.onlyHeldDirection(fit_with_information(1, 99));
    ASSERT_TRUE(held.has_value());
    EXPECT_NEAR(std::abs(held->y()), 1, 1e-12);
}

TEST(Drift, AllScansAreTrustedWhileLittleDriftIsToBeExpected)
{
    Drift drift(options());
    drift.held(travelled(100), fit_with_information(50, 50));
    EXPECT_EQ(drift.trustedBegin(travelled(109)), 0u);
}

TEST(Drift, AfterALongWayOnlyScansOfThisWayAreTrusted)
{
    Drift drift(options());
    drift.held(travelled(100), fit_with_information(50, 50));
    // 40 m since, and 20 m before that.
    EXPECT_EQ(drift.trustedBegin(travelled(140)), 80u);
}

TEST(Drift, RefusesKeysOutOfTheirRange)
{
    DriftOptions bad = options();
    bad.trusted_m = 0;
    EXPECT_THROW(Drift{bad}, std::invalid_argument);
}

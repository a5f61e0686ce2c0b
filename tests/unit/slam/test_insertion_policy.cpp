// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/insertion_policy.h>

#include <stdexcept>

using rtob::InsertionOptions;
using rtob::InsertionPolicy;
using rtob::Pose2;

namespace
{
/// A scan was written at time 100 s, at (1, 2) with yaw 3 rad.
InsertionPolicy after_a_scan(double distance_m, double angle_deg, double interval_s)
{
    InsertionPolicy policy({distance_m, angle_deg, interval_s});
    policy.inserted("laser", 100, {1, 2, 3});
    return policy;
}
}  // namespace

TEST(InsertionPolicy, TakesEveryScanWithoutDistanceAndAngle)
{
    InsertionPolicy policy({0, 0, 2});
    for (int k = 0; k < 3; ++k)
    {
        EXPECT_TRUE(policy.wants("laser", 5, {}));  // neither time nor place moves
        policy.inserted("laser", 5, {});
    }
}

TEST(InsertionPolicy, TakesTheFirstScanAlways)
{
    EXPECT_TRUE(InsertionPolicy({10, 90, 1000}).wants("laser", 0, {}));
}

TEST(InsertionPolicy, WaitsForTheDistance)
{
    const auto policy = after_a_scan(0.5, 0, 1000);
    EXPECT_FALSE(policy.wants("laser", 100.1, {1, 2, 3}));
    EXPECT_FALSE(policy.wants("laser", 100.1, {1.3, 2.39, 3}));  // 0.49 m
    EXPECT_TRUE(policy.wants("laser", 100.1, {1.3, 2.41, 3}));
    EXPECT_FALSE(policy.wants("laser", 100.1, {1, 2, 0})) << "no angle was asked for";
}

TEST(InsertionPolicy, WaitsForTheAngleAcrossTheWrap)
{
    const auto policy = after_a_scan(0, 30, 1000);  // 30 degrees are 0.5236 rad
    EXPECT_FALSE(policy.wants("laser", 100.1, {1, 2, 2.5}));
    EXPECT_TRUE(policy.wants("laser", 100.1, {1, 2, 2.45}));
    EXPECT_FALSE(policy.wants("laser", 100.1, {1, 2, rtob::wrap_angle(3.5)}));
    EXPECT_TRUE(policy.wants("laser", 100.1, {1, 2, rtob::wrap_angle(3.55)}));
    EXPECT_FALSE(policy.wants("laser", 100.1, {50, 2, 3})) << "no distance was asked for";
}

TEST(InsertionPolicy, WaitsNoLongerThanTheInterval)
{
    const auto policy = after_a_scan(0.5, 30, 2);
    EXPECT_FALSE(policy.wants("laser", 101.99, {1, 2, 3}));
    EXPECT_TRUE(policy.wants("laser", 102, {1, 2, 3}));
}

TEST(InsertionPolicy, MeasuresFromTheLastScanThatWasWritten)
{
    auto policy = after_a_scan(0.5, 0, 1000);
    policy.inserted("laser", 101, {1.6, 2, 3});
    EXPECT_FALSE(policy.wants("laser", 101.1, {2.0, 2, 3}));
    EXPECT_TRUE(policy.wants("laser", 101.1, {1.0, 2, 3}));
}

TEST(InsertionOptions, RefusesValuesOutOfRange)
{
    EXPECT_THROW(InsertionPolicy({-0.1, 0, 2}), std::invalid_argument);
    EXPECT_THROW(InsertionPolicy({0, -1, 2}), std::invalid_argument);
    EXPECT_THROW(InsertionPolicy({0, 0, 0}), std::invalid_argument);
}

TEST(InsertionPolicy, EachLaserHasItsOwnTurn)
{
    auto policy = after_a_scan(0.5, 30, 2);
    EXPECT_TRUE(policy.wants("another", 100.1, {1, 2, 3}));
    policy.inserted("another", 100.1, {1, 2, 3});
    EXPECT_FALSE(policy.wants("another", 100.2, {1, 2, 3}));
    EXPECT_FALSE(policy.wants("laser", 100.2, {1, 2, 3}));
}

TEST(InsertionPolicy, TakesTheFirstScanOfANewMap)
{
    auto policy = after_a_scan(0.5, 30, 2);
    policy.clear();
    EXPECT_TRUE(policy.wants("laser", 100.1, {1, 2, 3}));
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "motion_run.h"
#include "near_pose.h"

namespace rtob::test
{
namespace
{
using Kind = Measurement::Kind;

Measurement reading(Kind kind, double time_s, const Eigen::Vector3d& value, double sigma = 0.01)
{
    return {kind, time_s, value, Eigen::Matrix3d::Identity() * sigma * sigma};
}

void expect_same(const MotionState& a, const MotionState& b)
{
    EXPECT_EQ(a.time_s, b.time_s);
    EXPECT_EQ(a.mean, b.mean);
    EXPECT_EQ(a.covariance, b.covariance);
}
}  // namespace

TEST(MotionFilter, GoesOnWithTheVelocityThatFlowAndGyroTold)
{
    auto filter = started_filter();
    // 1 m/s ahead, a quarter turn a second to the left, for 1 s: a quarter circle.
    const double rate = 3.14159265358979323846 / 2;
    for (int i = 0; i <= 100; ++i)
    {
        filter.add(reading(Kind::YawRate, 0.01 * i, {rate, 0, 0}, 0.001));
        filter.add(reading(Kind::Velocity, 0.01 * i, {1, 0, 0}, 0.001));
    }
    const double radius_m = 1 / rate;
    // The gyro's bias is not known: its first 0.1 s fall on the velocity's prior.
    EXPECT_THAT(filter.at(1).pose(), IsNearPose(Pose2{radius_m, radius_m, rate}, 0.01, 0.03));
    EXPECT_THAT(filter.at(1).pose(), IsNearPose(carried({1, 0, rate}, 1), 0.01, 0.03));
}

/// One scan pose of sigma 1 on a prior of sigma 1 in each of x, y, yaw: half way, half the
/// variance.
TEST(MotionFilter, WeighsAScanAgainstWhatItKnew)
{
    MotionFilter filter;
    filter.start(0, {}, Eigen::Matrix3d::Identity());
    filter.addPose(reading(Kind::Pose, 0, {2, -2, 0.5}, 1));
    EXPECT_THAT(filter.at(0).pose(), IsNearPose(Pose2{1, -1, 0.25}, 1e-12, 1e-12));
    EXPECT_NEAR(filter.at(0).poseCovariance()(0, 0), 0.5, 1e-12);
}

/// Wheels know the way, whatever the scan between two readings said of the place.
TEST(MotionFilter, TakesOdometryForTheWayBetweenTwoReadings)
{
    auto filter = started_filter();
    filter.add(reading(Kind::WayBegin, 0, {0, 0, 0}));
    filter.addPose(reading(Kind::Pose, 0.05, {0.06, 0.02, 0.02}, 0.02));
    filter.add(reading(Kind::Way, 0.1, {0.1, 0, 0}, 1e-6));
    // The start was known to 0.1 mm: the way is measured from there.
    EXPECT_THAT(filter.at(0.1).pose(), IsNearPose(Pose2{0.1, 0, 0}, 0.001, 0.001));
}

TEST(MotionFilter, PutsLateReadingsInTheirPlace)
{
    MotionRun run({}, 7);
    std::vector<Measurement> readings;
    while (run.time_s() < 0.9)
        for (auto each : run.step())
        {
            if (each.kind == Kind::Velocity) each.time_s += 0.003;  // stamps of its own
            readings.push_back(each);
        }
    auto in_order = started_filter(), shuffled = started_filter();
    for (const auto& each : readings) in_order.add(each);
    // Flow comes after all others of each half second. Odometry keeps its own order.
    std::vector<Measurement> late = readings;
    std::stable_sort(
        late.begin(), late.end(),
        [](const Measurement& a, const Measurement& b)
        {
            const auto place = [](const Measurement& m)
            { return std::floor(2 * m.time_s) + (m.kind == Kind::Velocity ? 0.5 : 0); };
            return place(a) < place(b);
        });
    for (const auto& each : late) EXPECT_TRUE(shuffled.add(each));
    const auto a = in_order.at(1), b = shuffled.at(1);
    EXPECT_LT((a.mean - b.mean).norm(), 1e-12);
    EXPECT_LT((a.covariance - b.covariance).norm(), 1e-12);
}

TEST(MotionFilter, RefusesWhatIsOlderThanItsHistory)
{
    auto filter = started_filter();
    for (int i = 0; i < 300; ++i) filter.add(reading(Kind::YawRate, 0.01 * i, {0.1, 0, 0}));
    const auto before = filter.at(3);
    EXPECT_FALSE(filter.add(reading(Kind::YawRate, 1.5, {5, 0, 0})));
    expect_same(before, filter.at(3));
    EXPECT_TRUE(filter.add(reading(Kind::YawRate, 2.5, {0.1, 0, 0})));
}

TEST(MotionFilter, LeavesTheStateWhereAReadingIsBeyondTheGate)
{
    auto filter = started_filter();
    for (int i = 0; i < 100; ++i) filter.add(reading(Kind::YawRate, 0.01 * i, {0, 0, 0}));
    auto expected = filter.at(1);
    const auto innovation = filter.add(reading(Kind::YawRate, 1, {10, 0, 0}));
    ASSERT_TRUE(innovation);
    EXPECT_FALSE(innovation->used);
    EXPECT_GT(innovation->nis, 1000);
    expect_same(expected, filter.at(1));
}

/// After a closed loop the map says something else: the scan is right.
TEST(MotionFilter, IsPlacedWhereAScanFarOffSays)
{
    auto filter = started_filter();
    for (int i = 0; i < 100; ++i) filter.add(reading(Kind::Velocity, 0.01 * i, {1, 0, 0}));
    const auto innovation = filter.addPose(reading(Kind::Pose, 1, {5, 7, 1}));
    EXPECT_FALSE(innovation->used);
    EXPECT_THAT(filter.at(1).pose(), IsNearPose(Pose2{5, 7, 1}, 1e-9, 1e-9));
    EXPECT_NEAR(filter.at(1).twist().forward_mps, 1, 0.01);
    // The way from before the jump is no way in the map.
    filter.add(reading(Kind::Way, 1.1, {0.1, 0, 0}));
    EXPECT_NEAR(filter.at(1.1).pose().x, 5 + 0.1 * std::cos(1), 0.01);
}

TEST(MotionFilter, LearnsTheGyrosBiasFromScans)
{
    const double bias = 0.05;
    auto options = run_options();
    options.gyro_bias_degps = 5;
    auto filter = started_filter(options);
    for (int i = 1; i <= 1000; ++i)
    {
        filter.add(reading(Kind::YawRate, 0.01 * i, {bias, 0, 0}, 0.005));
        if (i % 20 == 0) filter.addPose(reading(Kind::Pose, 0.01 * i, {0, 0, 0}, 0.005));
    }
    EXPECT_NEAR(filter.at(10).mean[kGyroBias], bias, 0.003);
    EXPECT_NEAR(filter.at(10).mean[kTurn], 0, 0.01);
}

/// The derivatives that the covariance is moved on with, against small changes of the state: a
/// noise-free prediction of a nearby state.
TEST(MotionState, SpreadsAsItsNeighboursDo)
{
    const MotionNoise no_noise{0, 0, 0};
    MotionState state;
    state.mean << 1, 2, 0.7, 1.5, -0.4, 2, 0.1, 0, 0, 0;
    MotionMatrix spread;
    constexpr double small = 1e-6;
    for (int i = 0; i < kMotionSize; ++i)
    {
        MotionState more = state, less = state;
        more.mean[i] += small, less.mean[i] -= small;
        predict(more, 0.1, no_noise), predict(less, 0.1, no_noise);
        spread.col(i) = (more.mean - less.mean) / (2 * small);
    }
    state.covariance.setIdentity();
    predict(state, 0.1, no_noise);
    EXPECT_LT((state.covariance - spread * spread.transpose()).norm(), 1e-7);
}

TEST(MotionState, IsCarriedAlongAnArc)
{
    const double pi = 3.14159265358979323846;
    EXPECT_THAT(carried({1, 0, 0}, 2), IsNearPose(Pose2{2, 0, 0}, 1e-12, 1e-12));
    EXPECT_THAT(carried({pi, 0, pi}, 1), IsNearPose(Pose2{0, 2, -pi}, 1e-12, 1e-12));
    EXPECT_THAT(carried({0, pi, pi}, 1), IsNearPose(Pose2{-2, 0, -pi}, 1e-12, 1e-12));
    for (const double turn : {1e-8, 0.99e-4, 1.01e-4, -1e-4})  // across the branch
        EXPECT_THAT(
            carried({1, 2, turn}, 1), IsNearPose(Pose2{1 - turn, 2 + turn / 2, turn}, 1e-8, 1e-12));
}

TEST(NisGate, LetsTheAskedShareThrough)
{
    // Tables of the chi-square distribution, 0.1 %.
    const NisGate gate(0.001);
    EXPECT_NEAR(gate.limit[1], 10.828, 0.001);
    EXPECT_NEAR(gate.limit[2], 13.816, 0.001);
    EXPECT_NEAR(gate.limit[3], 16.266, 0.001);
}

TEST(FusionOptions, RefusesWhatIsOutOfRange)
{
    FusionOptions options;
    options.gate_chance = 0;
    EXPECT_THROW(MotionFilter{options}, std::invalid_argument);
    options = {};
    options.gyro_noise_degps = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(options.validate(), std::invalid_argument);
}
}  // namespace rtob::test

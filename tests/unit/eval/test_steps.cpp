// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/eval/steps.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "random_walk.h"

using namespace rtob;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

namespace
{
using Indices = std::vector<std::pair<std::size_t, std::size_t>>;

Indices steps(const std::vector<double>& positions_m, const StepOptions& options)
{
    std::vector<Pose2> path;
    for (const double position_m : positions_m) path.push_back({0, position_m, 0});
    Indices indices;
    for (const auto& [from, to] : steps_along(path, options)) indices.emplace_back(from, to);
    return indices;
}

StepOptions frames(double delta, StepChoice choice)
{
    return {delta, DeltaUnit::Frames, choice, 0};
}
StepOptions metres(double delta_m, StepChoice choice, double tolerance = 0)
{
    return {delta_m, DeltaUnit::Metres, choice, tolerance};
}

constexpr auto all = StepChoice::All;
constexpr auto consecutive = StepChoice::Consecutive;
}  // namespace

/// The cases of evo's test of its pairs by path; there the tolerances are in metres.
TEST(StepsAlong, AgreeWithEvosPublishedExpectations)
{
    EXPECT_THAT(
        steps({0, 1, 2, 3, 4}, metres(2, consecutive)), ElementsAre(Pair(0, 2), Pair(2, 4)));
    const std::vector<double> back_and_forth{0, 0.5, 0, 1};
    EXPECT_THAT(steps(back_and_forth, metres(1, all)), ElementsAre(Pair(0, 2), Pair(2, 3)));
    EXPECT_THAT(steps(back_and_forth, metres(2.5, all)), IsEmpty());
    EXPECT_THAT(steps({0, 0.5, 0.99, 1}, metres(1, all, 0.001)), ElementsAre(Pair(0, 3)));
    EXPECT_THAT(
        steps({0, 0.9, 0.99, 0.999, 0.9999, 0.99999, 0.999999, 0.9999999}, metres(1, all, 0.2)),
        ElementsAre(Pair(0, 7)));
}

TEST(StepsAlong, CountFrames)
{
    const std::vector<double> six(6, 0.0);
    EXPECT_THAT(steps(six, frames(2, consecutive)), ElementsAre(Pair(0, 2), Pair(2, 4)));
    EXPECT_THAT(steps(six, frames(3, all)), ElementsAre(Pair(0, 3), Pair(1, 4), Pair(2, 5)));
    EXPECT_THAT(steps(six, frames(5, consecutive)), ElementsAre(Pair(0, 5)));
    EXPECT_THAT(steps(six, frames(6, all)), IsEmpty());
    EXPECT_THAT(steps(six, frames(1e300, all)), IsEmpty());
    EXPECT_EQ(steps(six, frames(1, all)), steps(six, frames(1, consecutive)));
    EXPECT_THAT(steps({0}, frames(1, all)), IsEmpty());
    EXPECT_THAT(steps({}, frames(1, consecutive)), IsEmpty());
}

TEST(StepsAlong, EndConsecutiveOnesWithTheFirstPoseFarEnough)
{
    // From 0 to 0.9 is not enough, 1.4 is; from there 2.3 is not, 2.4 is.
    EXPECT_THAT(
        steps({0, 0.9, 1.4, 2.3, 2.4, 3.3}, metres(1, consecutive)),
        ElementsAre(Pair(0, 2), Pair(2, 4)));
}

TEST(StepsAlong, MeasureAlongThePath)
{
    // There and back: 1 m is driven though the vehicle is where it was.
    EXPECT_THAT(steps({0, 0.5, 0}, metres(1, consecutive)), ElementsAre(Pair(0, 2)));
}

TEST(StepsAlong, TakeTheFirstPoseWhereTheVehicleStands)
{
    EXPECT_THAT(steps({0, 0.95, 0.95, 1.2}, metres(1, all, 0.1)), ElementsAre(Pair(0, 1)));
    EXPECT_THAT(steps({0, 0, 0}, metres(1, all, 0.1)), IsEmpty());
    EXPECT_THAT(steps({}, metres(1, all, 0.1)), IsEmpty());
}

TEST(StepsAlong, EqualTheSlowSearch)
{
    std::vector<Pose2> path;
    for (const auto& stamped : test::random_walk(200, 4)) path.push_back(stamped.pose);
    for (std::size_t i = 50; i < 60; ++i) path[i] = path[50];  // it stands for a while
    std::vector<double> driven{0};
    for (std::size_t i = 1; i < path.size(); ++i)
        driven.push_back(
            driven.back() + std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y));
    Indices expected;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
        const auto off = [&](std::size_t j) { return std::abs(driven[j] - driven[i] - 5); };
        std::size_t best = i + 1;
        for (std::size_t j = i + 1; j < path.size(); ++j)
            if (off(j) < off(best)) best = j;
        if (off(best) <= 0.2) expected.emplace_back(i, best);
    }
    ASSERT_GT(expected.size(), 20u);
    Indices found;
    for (const auto& [from, to] : steps_along(path, metres(5, all, 0.04)))
        found.emplace_back(from, to);
    EXPECT_EQ(found, expected);
}

TEST(StepsAlong, RefuseOptionsOutOfRange)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const auto& options :
         {frames(0, all), frames(1.5, all), frames(-1, all), metres(0, all), metres(nan, all),
          metres(1, all, -0.1)})
        EXPECT_THROW(static_cast<void>(steps({0, 1}, options)), std::invalid_argument);
}

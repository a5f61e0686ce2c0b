// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/eval/association.h>

#include <cmath>
#include <limits>

#include "error_message.h"
#include "random_walk.h"

using namespace rtob;
using rtob::test::error_message;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

namespace
{
constexpr double nan_d = std::numeric_limits<double>::quiet_NaN();

std::vector<StampedPose2> at(const std::vector<double>& stamps_s)
{
    std::vector<StampedPose2> trajectory;
    for (const double stamp_s : stamps_s) trajectory.push_back({stamp_s, {}});
    return trajectory;
}

using Indices = std::vector<std::pair<std::size_t, std::size_t>>;

/// (estimate, reference) pairs.
Indices matched(
    const std::vector<double>& estimate_s, const std::vector<double>& reference_s,
    double max_difference_s = 0.01)
{
    Indices indices;
    for (const auto& match : match_by_time(at(estimate_s), at(reference_s), max_difference_s))
        indices.emplace_back(match.estimate_index, match.reference_index);
    return indices;
}

std::vector<double> stamps(std::size_t n, double step_s, double start_s = 0)
{
    std::vector<double> all;
    for (std::size_t i = 0; i < n; ++i) all.push_back(start_s + step_s * static_cast<double>(i));
    return all;
}

std::string refusal(
    const std::vector<StampedPose2>& estimate, const std::vector<StampedPose2>& reference)
{
    return error_message([&] { static_cast<void>(match_by_time(estimate, reference)); });
}
}  // namespace

/// The cases of evo's test of its time matching.
TEST(MatchByTime, AgreesWithEvosPublishedExpectations)
{
    EXPECT_THAT(matched({0.005}, {0, 0.01}, 0.006), ElementsAre(Pair(0, 0)));
    EXPECT_THAT(matched({0}, {1, 0, 2}), ElementsAre(Pair(0, 1)));
    EXPECT_THAT(matched({1, 2}, {1, 1, 2}), ElementsAre(Pair(0, 0), Pair(1, 2)));
    EXPECT_EQ(matched(stamps(10, 0.1, 0.01), stamps(500, 2e-3)).size(), 10u);
    EXPECT_EQ(matched(stamps(500, 2e-3), stamps(10, 0.1, 0.01), 1e-3).size(), 10u);
    EXPECT_EQ(matched(stamps(10, 0.1), stamps(100, 0.01)).size(), 10u);
}

TEST(MatchByTime, TakesTheNearestStampOfTheLongerTrajectory)
{
    EXPECT_THAT(
        matched({10.004, 12.995}, {10, 10.006, 11, 13}), ElementsAre(Pair(0, 1), Pair(1, 3)));
    EXPECT_THAT(matched({10, 10.006, 11, 13}, {10.004}), ElementsAre(Pair(1, 0)))
        << "the roles change, the pairs do not";
}

TEST(MatchByTime, AcceptsADifferenceUpToTheLimit)
{
    EXPECT_THAT(matched({1, 2, 3}, {1.25, 2.5, 3.5}, 0.25), ElementsAre(Pair(0, 0)));
    EXPECT_THAT(matched({1, 2}, {1, 2.001}, 0), ElementsAre(Pair(0, 0)));
}

TEST(MatchByTime, UsesNoPoseTwice)
{
    EXPECT_THAT(matched({1.008, 1.002}, {1, 5, 6}), ElementsAre(Pair(1, 0)))
        << "the nearest claim wins";
    EXPECT_THAT(matched({1, 1, 1}, {1, 5, 6}), ElementsAre(Pair(0, 0))) << "then the first";
}

TEST(MatchByTime, KeepsRepeatedStampsInTheirOrder)
{
    const std::vector<double> both{1, 2, 2, 3, 3, 3};
    Indices same;
    for (std::size_t i = 0; i < both.size(); ++i) same.emplace_back(i, i);
    EXPECT_EQ(matched(both, both), same);
    EXPECT_THAT(matched({1, 2, 2, 3}, {1, 2, 3}), ElementsAre(Pair(0, 0), Pair(1, 1), Pair(3, 2)));
}

TEST(MatchByTime, KeepsTheEstimatesOrderWhereStampsStepBack)
{
    EXPECT_THAT(
        matched({1, 2, 1.5, 3}, {1, 1.5, 2, 3}),
        ElementsAre(Pair(0, 0), Pair(1, 2), Pair(2, 1), Pair(3, 3)));
}

TEST(MatchByTime, GivesBothPosesAndTheEstimatesTime)
{
    const auto match = match_by_time({{5, {1, 2, 3}}}, {{5.001, {4, 5, -1}}}).at(0);
    EXPECT_EQ(match.time_s, 5);
    EXPECT_EQ(match.estimate.y, 2);
    EXPECT_EQ(match.reference.yaw, -1);
}

/// Against the rule itself, pose by pose, for stamps without repeats and with a clear nearest one.
TEST(MatchByTime, EqualsTheSlowSearch)
{
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> time_s(0, 10);
    std::vector<double> estimate_s(40), reference_s(400);
    for (auto& t : estimate_s) t = time_s(generator);
    for (auto& t : reference_s) t = time_s(generator);
    Indices expected;
    std::vector<bool> is_used(reference_s.size(), false);
    for (std::size_t i = 0; i < estimate_s.size(); ++i)
    {
        std::size_t best = 0;
        for (std::size_t j = 0; j < reference_s.size(); ++j)
            if (std::abs(reference_s[j] - estimate_s[i]) <
                std::abs(reference_s[best] - estimate_s[i]))
                best = j;
        if (std::abs(reference_s[best] - estimate_s[i]) > 0.01) continue;
        ASSERT_FALSE(is_used[best]) << "this seed needs the rule of the nearest claim";
        is_used[best] = true;
        expected.emplace_back(i, best);
    }
    ASSERT_GT(expected.size(), 10u);
    EXPECT_LT(expected.size(), estimate_s.size());
    EXPECT_EQ(matched(estimate_s, reference_s), expected);
}

TEST(MatchByTime, SaysWhyNothingMatches)
{
    EXPECT_THAT(
        refusal(at({1, 2, 3}), at({101, 102})),
        AllOf(
            HasSubstr("3 poses from 1.000000 s to 3.000000 s"),
            HasSubstr("2 poses from 101.000000 s to 102.000000 s"), HasSubstr("98.000000 s apart"),
            HasSubstr("within 0.010000 s")));
    EXPECT_THAT(refusal(at({1, 2}), at({1.02, 1.5})), HasSubstr("nearest two are 0.020000 s"));
}

TEST(MatchByTime, RefusesEmptyAndNotFiniteData)
{
    EXPECT_THAT(refusal({}, at({1})), HasSubstr("the estimate has no poses"));
    EXPECT_THAT(refusal(at({1}), {}), HasSubstr("the reference has no poses"));
    EXPECT_THAT(
        refusal(at({1, nan_d}), at({1})), HasSubstr("stamp of pose 2 of the estimate is not"));
    EXPECT_THAT(
        refusal({{1, {0, 0, 0}}, {2, {0, nan_d, 0}}}, at({1, 2})),
        HasSubstr("the pose of the estimate at 2.000000 s is not finite"));
    EXPECT_THAT(
        refusal(at({1}), {{1, {0, 0, nan_d}}}),
        HasSubstr("the pose of the reference at 1.000000 s is not finite"));
    EXPECT_THAT(refusal({{1, {}}, {2, {nan_d, 0, 0}}}, at({1})), IsEmpty()) << "it matches nothing";
    EXPECT_THROW(static_cast<void>(match_by_time(at({1}), at({1}), -1)), std::invalid_argument);
}

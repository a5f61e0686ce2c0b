// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rtob/eval/relations.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "error_message.h"
#include "random_walk.h"

using namespace rtob;
using rtob::test::error_message;
using rtob::test::random_walk;
using testing::HasSubstr;

namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double rad_per_deg = pi / 180;

/// The true relation between each pose and the one three later.
std::vector<Relation> true_relations(const std::vector<StampedPose2>& walk)
{
    std::vector<Relation> relations;
    for (std::size_t i = 0; i + 3 < walk.size(); ++i)
        relations.push_back(
            {walk[i].time_s, walk[i + 3].time_s, between(walk[i].pose, walk[i + 3].pose)});
    return relations;
}
}  // namespace

TEST(RelationErrors, AreZeroForTheTruth)
{
    const auto walk = random_walk(50, 1);
    const auto errors = relation_errors(walk, true_relations(walk));
    EXPECT_EQ(errors.residuals.size(), 47u);
    EXPECT_EQ(errors.unmatched_relations, 0u);
    EXPECT_NEAR(errors.distance_m.mean, 0, 1e-12);
    EXPECT_NEAR(errors.turn_deg.mean, 0, 1e-12);
}

TEST(RelationErrors, AreTheHandComputedOnes)
{
    // The vehicle looks along +y at t = 1, then stands 2 m ahead and turned right by 90 deg: seen
    // from the first pose it is at (2, 0), -90 deg.
    const std::vector<StampedPose2> trajectory{{1, {1, 1, pi / 2}}, {2, {1, 3, 0}}};
    // Residuals: (2, 0) - (2 - 0.3, 0.4) is 0.5 m long, 10 deg off; then 0.1 m and 0 deg.
    const std::vector<Relation> relations{
        {1, 2, {1.7, 0.4, -100 * rad_per_deg}}, {1, 2, {2, 0.1, -pi / 2}}};
    const auto errors = relation_errors(trajectory, relations);
    EXPECT_NEAR(errors.residuals[0].distance_m, 0.5, 1e-12);
    EXPECT_NEAR(errors.residuals[0].turn_deg, 10, 1e-9);
    EXPECT_NEAR(errors.residuals[1].distance_m, 0.1, 1e-12);
    EXPECT_NEAR(errors.residuals[1].turn_deg, 0, 1e-9);
    EXPECT_NEAR(errors.distance_m.mean, 0.3, 1e-12);  // (0.5 + 0.1) / 2
    EXPECT_NEAR(errors.distance_m.std, 0.2, 1e-12);
    EXPECT_NEAR(errors.squared_distance_m2.mean, 0.13, 1e-12);  // (0.25 + 0.01) / 2
    EXPECT_NEAR(errors.squared_distance_m2.std, 0.12, 1e-12);
    EXPECT_NEAR(errors.turn_deg.mean, 5, 1e-9);
    EXPECT_NEAR(errors.turn_deg.std, 5, 1e-9);
    EXPECT_NEAR(errors.squared_turn_deg2.mean, 50, 1e-8);
    EXPECT_NEAR(errors.squared_turn_deg2.std, 50, 1e-8);
}

TEST(RelationErrors, MeasureTurnsAcrossTheWrap)
{
    const std::vector<StampedPose2> trajectory{{1, {}}, {2, {0, 0, 179 * rad_per_deg}}};
    const auto errors = relation_errors(trajectory, {{1, 2, {0, 0, -179 * rad_per_deg}}});
    EXPECT_NEAR(errors.turn_deg.mean, 2, 1e-9);
}

TEST(RelationErrors, DoNotDependOnTheMapFrame)
{
    auto walk = random_walk(80, 2);
    const auto relations = true_relations(random_walk(80, 3));  // of another walk: large errors
    const auto errors = relation_errors(walk, relations);
    for (auto& stamped : walk) stamped.pose = compose({-70, 30, 2.5}, stamped.pose);
    const auto moved = relation_errors(walk, relations);
    EXPECT_GT(errors.distance_m.mean, 0.5);
    ASSERT_EQ(errors.residuals.size(), moved.residuals.size());
    for (std::size_t i = 0; i < moved.residuals.size(); ++i)
    {
        EXPECT_NEAR(errors.residuals[i].distance_m, moved.residuals[i].distance_m, 1e-11);
        EXPECT_NEAR(errors.residuals[i].turn_deg, moved.residuals[i].turn_deg, 1e-10);
    }
}

TEST(RelationErrors, DoNotDependOnTheOrderOfThePoses)
{
    auto walk = random_walk(80, 4);
    const auto relations = true_relations(walk);
    std::shuffle(walk.begin(), walk.end(), std::mt19937(5));
    EXPECT_NEAR(relation_errors(walk, relations).distance_m.mean, 0, 1e-12);
}

TEST(RelationErrors, OfConstructedErrorsAreExact)
{
    // relation = truth composed with the inverse of a known motion, so that motion is the residual.
    const auto walk = random_walk(40, 6);
    auto relations = true_relations(walk);
    const Pose2 residual{0.03, -0.04, 3 * rad_per_deg};
    for (auto& relation : relations)
        relation.pose_1_2 = compose(relation.pose_1_2, inverse(residual));
    for (const auto& found : relation_errors(walk, relations).residuals)
    {
        EXPECT_NEAR(found.distance_m, 0.05, 1e-12);
        EXPECT_NEAR(found.turn_deg, 3, 1e-10);
    }
}

TEST(RelationErrors, MatchStampsWithinATenthOfAMillisecond)
{
    const std::vector<StampedPose2> trajectory{
        {1e9, {}}, {1e9 + 0.00015, {5, 0, 0}}, {1e9 + 1, {9, 0, 0}}};
    const auto distance = [&](double t1_s) {
        return relation_errors(trajectory, {{t1_s, 1e9 + 1, {}}}).distance_m.mean;
    };
    EXPECT_DOUBLE_EQ(distance(1e9 - 0.00009), 9);
    EXPECT_DOUBLE_EQ(distance(1e9 + 0.00006), 9);  // 60 us after the first, 90 us before the second
    EXPECT_DOUBLE_EQ(distance(1e9 + 0.00009), 4);  // nearer to the second
    EXPECT_THROW((void)distance(1e9 - 0.00011), std::runtime_error);
}

TEST(RelationErrors, TakeTheFirstOfPosesWithOneStamp)
{
    const std::vector<StampedPose2> trajectory{
        {3, {}}, {2, {1, 0, 0}}, {2, {8, 0, 0}}, {1, {}}, {2, {9, 0, 0}}};
    for (const double t2_s : {2.0, 2.00005, 1.99995})
        EXPECT_EQ(relation_errors(trajectory, {{1, t2_s, {}}}).distance_m.mean, 1);
}

TEST(RelationErrors, CountRelationsWithoutPoses)
{
    const std::vector<StampedPose2> trajectory{{1, {}}, {2, {1, 0, 0}}};
    const auto errors = relation_errors(trajectory, {{1, 7, {}}, {1, 2, {}}, {7, 2, {}}});
    EXPECT_EQ(errors.unmatched_relations, 2u);
    ASSERT_EQ(errors.residuals.size(), 1u);
    EXPECT_EQ(errors.residuals[0].relation, 1u);
}

TEST(RelationErrors, WithoutAnyMatchAreAnError)
{
    const auto error = [](const std::vector<StampedPose2>& trajectory) {
        return error_message([&] { (void)relation_errors(trajectory, {{100, 200, {}}}); });
    };
    EXPECT_THAT(error({}), HasSubstr("the trajectory has no poses"));
    EXPECT_THAT(
        error({{1, {}}, {2, {}}}),
        HasSubstr("from 1.000000 s to 2.000000 s, the first relation starts at 100"));
    EXPECT_THROW((void)relation_errors({{1, {}}}, {}), std::runtime_error);
}

TEST(RelationErrors, RefuseWhatIsNotFinite)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto error = [](const std::vector<StampedPose2>& trajectory) {
        return error_message([&] { (void)relation_errors(trajectory, {{1, 2, {}}}); });
    };
    EXPECT_THAT(error({{1, {}}, {2, {nan, 0, 0}}}), HasSubstr("pose at 2.000000 s is not finite"));
    EXPECT_THAT(error({{1, {}}, {2, {0, 0, nan}}}), HasSubstr("pose at 2.000000 s is not finite"));
    EXPECT_THAT(error({{1, {}}, {nan, {}}}), HasSubstr("stamp of the trajectory is not finite"));
}

TEST(WorstResiduals, AreSortedByDistance)
{
    const std::vector<StampedPose2> trajectory{{1, {}}, {2, {}}};
    const auto errors =
        relation_errors(trajectory, {{1, 2, {0.1, 0, 0}}, {1, 2, {0, 3, 0}}, {1, 2, {2, 0, 0}}});
    const auto worst = worst_residuals(errors, 2);
    ASSERT_EQ(worst.size(), 2u);
    EXPECT_EQ(worst[0].relation, 1u);
    EXPECT_EQ(worst[1].relation, 2u);
    EXPECT_EQ(worst_residuals(errors, 99).size(), 3u);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/core/enum_names.h>
#include <rtob/eval/alignment.h>

#include <Eigen/Geometry>
#include <cmath>

#include "error_message.h"
#include "near_pose.h"
#include "random_walk.h"

using namespace rtob;
using rtob::test::error_message;
using rtob::test::IsNearPose;
using rtob::test::random_walk;
using rtob::test::seen_from;
using testing::HasSubstr;

namespace
{
constexpr double pi = 3.14159265358979323846;

std::vector<PoseMatch> matches_of(
    const std::vector<Pose2>& estimate, const std::vector<Pose2>& reference)
{
    std::vector<PoseMatch> matches;
    for (std::size_t i = 0; i < estimate.size(); ++i)
        matches.push_back({i, i, static_cast<double>(i), estimate[i], reference[i]});
    return matches;
}

double squares_m2(const std::vector<PoseMatch>& matches, const Pose2& motion)
{
    double sum = 0;
    for (const auto& match : moved_estimates(matches, motion))
        sum += std::pow(match.estimate.x - match.reference.x, 2) +
               std::pow(match.estimate.y - match.reference.y, 2);
    return sum;
}

std::string refusal(const std::vector<PoseMatch>& matches)
{
    return error_message([&] { static_cast<void>(alignment_of(matches, Alignment::Se2)); });
}
}  // namespace

TEST(Alignment, NoneLeavesTheEstimateWhereItIs)
{
    EXPECT_THAT(
        alignment_of(matches_of({{1, 2, 3}}, {{5, 5, 0}}), Alignment::None),
        IsNearPose(Pose2{}, 0, 0));
}

TEST(Alignment, OriginLaysTheFirstPosesOnEachOther)
{
    // (1, 0) looking along +x becomes (3, 3) looking along +y: the next pose, 2 m ahead, is at
    // (3, 5) whatever the reference says there.
    const auto matches = matches_of({{1, 0, 0}, {3, 0, 0.5}}, {{3, 3, pi / 2}, {90, 90, 0}});
    const auto moved = moved_estimates(matches, alignment_of(matches, Alignment::Origin));
    EXPECT_THAT(moved[0].estimate, IsNearPose(moved[0].reference, 1e-12, 1e-12));
    EXPECT_THAT(moved[1].estimate, IsNearPose(Pose2{3, 5, pi / 2 + 0.5}, 1e-12, 1e-12));
}

TEST(Alignment, Se2RecoversAShiftAndTurn)
{
    for (const double yaw : {0.0, 1e-8, 0.7, pi / 2, 3.1, -3.1, -pi})
    {
        const auto walk = random_walk(60, 7);
        const Pose2 motion{-40, 25, wrap_angle(yaw)};
        const auto found =
            alignment_of(match_by_time(walk, seen_from(motion, walk)), Alignment::Se2);
        EXPECT_THAT(found, IsNearPose(motion, 1e-11, 1e-12)) << yaw;
    }
}

TEST(Alignment, Se2HoldsOnAStraightLine)
{
    // A corridor: the positions are on a line, the turn is known nevertheless.
    const auto matches =
        matches_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{5, 1, 0}, {5, 2, 0}, {5, 3, 0}});
    EXPECT_THAT(
        alignment_of(matches, Alignment::Se2), IsNearPose(Pose2{5, 1, pi / 2}, 1e-12, 1e-12));
}

TEST(Alignment, Se2IsTheHandComputedLeastSquares)
{
    // A bar of 2 m against one of 4 m: it is laid in the middle, and not scaled.
    const auto matches = matches_of({{-1, 0, 0}, {1, 0, 0}}, {{10, 8, 0}, {10, 12, 0}});
    const auto motion = alignment_of(matches, Alignment::Se2);
    EXPECT_THAT(motion, IsNearPose(Pose2{10, 10, pi / 2}, 1e-12, 1e-12));
    EXPECT_NEAR(squares_m2(matches, motion), 2, 1e-12);  // 1 m at each end
}

/// Another implementation of the same paper, by singular values.
TEST(Alignment, Se2IsEigensUmeyamaWithoutScale)
{
    const auto matches = match_by_time(random_walk(40, 11), random_walk(40, 12));
    Eigen::MatrixXd estimate(2, matches.size()), reference(2, matches.size());
    for (std::size_t i = 0; i < matches.size(); ++i)
    {
        const auto column = static_cast<Eigen::Index>(i);
        estimate.col(column) << matches[i].estimate.x, matches[i].estimate.y;
        reference.col(column) << matches[i].reference.x, matches[i].reference.y;
    }
    const Eigen::MatrixXd expected = Eigen::umeyama(estimate, reference, false);
    EXPECT_THAT(
        alignment_of(matches, Alignment::Se2),
        IsNearPose(
            Pose2{expected(0, 2), expected(1, 2), std::atan2(expected(1, 0), expected(0, 0))},
            1e-11, 1e-12));
}

TEST(Alignment, Se2CannotBeBetteredByAnySmallMotion)
{
    const auto matches = match_by_time(random_walk(50, 8), random_walk(50, 9));
    const Pose2 best = alignment_of(matches, Alignment::Se2);
    const double least = squares_m2(matches, best);
    for (const double step : {-1e-3, 1e-3})
        for (const Pose2& change : {Pose2{step, 0, 0}, Pose2{0, step, 0}, Pose2{0, 0, step}})
            EXPECT_GT(squares_m2(matches, compose(change, best)), least);
}

TEST(Alignment, Se2RefusesWhatLeavesTheTurnOpen)
{
    EXPECT_THAT(
        refusal(matches_of({{1, 2, 3}}, {{1, 2, 3}})),
        HasSubstr("finds no turn: only one pose is matched. Align by the origin"));
    EXPECT_THAT(
        refusal(matches_of({{0, 0, 0}, {1, 0, 0}}, {{7e5, 8e5, 0}, {7e5, 8e5, 1}})),
        HasSubstr("the 2 matched poses of the reference are all in one place"));
    // A square and its mirror image.
    EXPECT_THAT(
        refusal(matches_of(
            {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
            {{1, 0, 0}, {0, -1, 0}, {-1, 0, 0}, {0, 1, 0}})),
        HasSubstr("nothing in common"));
    EXPECT_THAT(refusal({}), HasSubstr("no matched poses"));
}

TEST(Alignment, HasNames)
{
    EXPECT_EQ(parse_enum<Alignment>("se2"), Alignment::Se2);
    EXPECT_EQ(name_of(Alignment::Origin), "origin");
}

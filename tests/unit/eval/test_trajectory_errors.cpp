// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/eval/trajectory_score.h>

#include <cmath>

#include "error_message.h"
#include "near_pose.h"
#include "random_walk.h"

using namespace rtob;
using rtob::test::error_message;
using rtob::test::random_walk;
using rtob::test::seen_from;
using testing::HasSubstr;

namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double rad_per_deg = pi / 180;

ScoreOptions aligned_by(Alignment alignment)
{
    ScoreOptions options;
    options.alignment = alignment;
    return options;
}

void expect_near(const ErrorStatistics& a, const ErrorStatistics& b, double tolerance)
{
    EXPECT_NEAR(a.rmse, b.rmse, tolerance);
    EXPECT_NEAR(a.mean, b.mean, tolerance);
    EXPECT_NEAR(a.median, b.median, tolerance);
    EXPECT_NEAR(a.std, b.std, tolerance);
    EXPECT_NEAR(a.min, b.min, tolerance);
    EXPECT_NEAR(a.max, b.max, tolerance);
}

void expect_near(const PoseErrors& a, const PoseErrors& b)
{
    expect_near(a.distance_m, b.distance_m, 1e-10);
    expect_near(a.turn_deg, b.turn_deg, 1e-8);
    expect_near(a.full, b.full, 1e-10);
}

/// The truth with another, large error at each pose.
std::vector<StampedPose2> disturbed(std::vector<StampedPose2> truth, unsigned seed)
{
    const auto errors = random_walk(truth.size(), seed);
    for (std::size_t i = 0; i < truth.size(); ++i)
        truth[i].pose = compose(truth[i].pose, errors[i].pose);
    return truth;
}
}  // namespace

TEST(AbsoluteErrors, AreTheHandComputedOnes)
{
    // Off by (3, 4) m and 10 deg, then by (0, -1) m and 0 deg, then by nothing and 180 deg.
    const std::vector<PoseMatch> matches{
        {0, 0, 0, {3, 4, 10 * rad_per_deg}, {0, 0, 0}},
        {1, 1, 1, {5, 4, 1}, {5, 5, 1}},
        {2, 2, 2, {2, 2, -pi}, {2, 2, 0}}};
    const auto found = absolute_errors(matches);
    EXPECT_NEAR(found.errors[0].distance_m, 5, 1e-12);
    EXPECT_NEAR(found.errors[0].turn_deg, 10, 1e-12);
    // |E - I|^2 = 25 + 2 (cos 10 deg - 1)^2 + 2 sin^2 10 deg = 25 + 0.000461609 + 0.060307379
    EXPECT_NEAR(found.errors[0].full, std::sqrt(25.060768988), 1e-9);
    EXPECT_NEAR(found.errors[2].full, std::sqrt(8), 1e-12);  // diag(-2, -2)
    EXPECT_NEAR(found.distance_m.mean, 2, 1e-12);            // 5, 1, 0
    EXPECT_NEAR(found.distance_m.median, 1, 1e-12);
    EXPECT_NEAR(found.distance_m.sse, 26, 1e-12);
    EXPECT_NEAR(found.distance_m.rmse, std::sqrt(26 / 3.0), 1e-12);
    EXPECT_NEAR(found.turn_deg.max, 180, 1e-12);
    EXPECT_NEAR(found.turn_deg.min, 0, 1e-12);
    EXPECT_EQ(found.errors[1].match, 1u);
}

TEST(AbsoluteErrors, MeasureTurnsAcrossTheWrap)
{
    const auto found =
        absolute_errors({{0, 0, 0, {0, 0, 179 * rad_per_deg}, {0, 0, -179 * rad_per_deg}}});
    EXPECT_NEAR(found.turn_deg.max, 2, 1e-9);
}

TEST(RelativeErrors, AreTheHandComputedOnes)
{
    // The reference drives a metre ahead three times. The estimate says 1.1 m, then 1 m with a turn
    // of 90 deg at its end, then 1 m along that new heading.
    const std::vector<PoseMatch> matches{
        {0, 0, 0, {0, 0, 0}, {0, 0, 0}},
        {1, 1, 1, {1.1, 0, 0}, {1, 0, 0}},
        {2, 2, 2, {2.1, 0, pi / 2}, {2, 0, 0}},
        {3, 3, 3, {2.1, 1, pi / 2}, {3, 0, 0}}};
    const auto steps = relative_errors(matches);
    ASSERT_EQ(steps.errors.size(), 3u);
    EXPECT_NEAR(steps.errors[0].distance_m, 0.1, 1e-12);
    EXPECT_NEAR(steps.errors[1].distance_m, 0, 1e-12);
    EXPECT_NEAR(steps.errors[1].turn_deg, 90, 1e-12);
    EXPECT_NEAR(steps.errors[1].full, 2, 1e-12);  // 8 sin^2(45 deg) = 4
    EXPECT_NEAR(steps.errors[2].distance_m, 0, 1e-12) << "the wrong heading counts just once";
    EXPECT_EQ(steps.errors[2].match, 3u);

    // Over all three steps: (2.1, 1) instead of (3, 0).
    RelativeErrorOptions three;
    three.steps.delta = 3;
    const auto long_step = relative_errors(matches, three);
    ASSERT_EQ(long_step.errors.size(), 1u);
    EXPECT_NEAR(long_step.distance_m.max, std::hypot(0.9, 1), 1e-12);
}

TEST(RelativeErrors, MeasureTheStepsOnThePathThatIsAskedFor)
{
    // The estimate thinks that it drives twice as far: two of its metres are one of the truth's.
    std::vector<PoseMatch> matches;
    for (std::size_t i = 0; i < 9; ++i)
    {
        const auto x = static_cast<double>(i);
        matches.push_back({i, i, x, {2 * x, 0, 0}, {x, 0, 0}});
    }
    RelativeErrorOptions options;
    options.steps.unit = DeltaUnit::Metres;
    options.steps.delta = 4;
    EXPECT_EQ(relative_errors(matches, options).errors.size(), 4u);
    EXPECT_NEAR(relative_errors(matches, options).distance_m.mean, 2, 1e-12);
    options.steps_of_reference = true;
    EXPECT_EQ(relative_errors(matches, options).errors.size(), 2u);
    EXPECT_NEAR(relative_errors(matches, options).distance_m.mean, 4, 1e-12);
}

TEST(RelativeErrors, NameTheStepThatIsTooLong)
{
    RelativeErrorOptions options;
    options.steps.unit = DeltaUnit::Metres;
    options.steps.delta = 2.5;
    const std::vector<PoseMatch> one(1);
    EXPECT_THAT(
        error_message([&] { static_cast<void>(relative_errors(one, options)); }),
        HasSubstr("no two of the 1 matched poses are 2.5 m apart"));
    EXPECT_THAT(
        error_message([&] { static_cast<void>(relative_errors(one)); }),
        HasSubstr("are 1 frame apart"));
}

TEST(ScoreTrajectory, IsZeroForTheTruth)
{
    const auto walk = random_walk(50, 1);
    for (const auto alignment : {Alignment::None, Alignment::Origin, Alignment::Se2})
    {
        const auto score = score_trajectory(walk, walk, aligned_by(alignment));
        EXPECT_EQ(score.matches.size(), 50u);
        EXPECT_NEAR(score.absolute.full.max, 0, 1e-11);
        EXPECT_NEAR(score.relative.at(0).full.max, 0, 1e-11);
    }
}

TEST(ScoreTrajectory, DoesNotDependOnTheEstimatesMapWhenAligned)
{
    const auto truth = random_walk(80, 2);
    const auto estimate = disturbed(truth, 3);
    for (const auto alignment : {Alignment::Origin, Alignment::Se2})
    {
        const auto score = score_trajectory(estimate, truth, aligned_by(alignment));
        EXPECT_GT(score.absolute.distance_m.rmse, 0.5);
        for (const Pose2& motion : {Pose2{-70, 30, 2.5}, Pose2{1e-8, 0, 1e-8}, Pose2{5, 5, -pi}})
        {
            const auto moved =
                score_trajectory(seen_from(motion, estimate), truth, aligned_by(alignment));
            expect_near(score.absolute, moved.absolute);
        }
    }
}

TEST(ScoreTrajectory, DoesNotDependOnTheMapThatBothShare)
{
    const auto truth = random_walk(80, 4);
    const auto estimate = disturbed(truth, 5);
    const Pose2 motion{20, -10, 1.2};
    for (const auto alignment : {Alignment::None, Alignment::Origin, Alignment::Se2})
        expect_near(
            score_trajectory(estimate, truth, aligned_by(alignment)).absolute,
            score_trajectory(
                seen_from(motion, estimate), seen_from(motion, truth), aligned_by(alignment))
                .absolute);
}

TEST(ScoreTrajectory, HasARelativeErrorThatNoAlignmentChanges)
{
    const auto truth = random_walk(80, 6);
    const auto estimate = disturbed(truth, 7);
    RelativeErrorOptions far;
    far.steps = {4, DeltaUnit::Metres, StepChoice::All, 0.1};
    ScoreOptions options = aligned_by(Alignment::None);
    options.relative = {{}, far};
    const auto plain = score_trajectory(estimate, truth, options);
    const auto moved = score_trajectory(seen_from({-70, 30, 2.5}, estimate), truth, options);
    options.alignment = Alignment::Se2;
    const auto aligned = score_trajectory(estimate, truth, options);
    for (std::size_t i = 0; i < 2; ++i)
    {
        EXPECT_GT(plain.relative[i].distance_m.rmse, 0.5);
        expect_near(plain.relative[i], moved.relative[i]);
        expect_near(plain.relative[i], aligned.relative[i]);
    }
}

TEST(ScoreTrajectory, FindsAConstructedErrorExactly)
{
    // Every pose is off by the same motion as seen from itself: 5 cm and 3 deg.
    const auto truth = random_walk(40, 8);
    const Pose2 error{0.03, -0.04, 3 * rad_per_deg};
    auto estimate = truth;
    for (auto& stamped : estimate) stamped.pose = compose(stamped.pose, error);
    const auto score = score_trajectory(estimate, truth, aligned_by(Alignment::None));
    for (const auto& found : score.absolute.errors)
    {
        EXPECT_NEAR(found.distance_m, 0.05, 1e-12);
        EXPECT_NEAR(found.turn_deg, 3, 1e-10);
    }
    EXPECT_NEAR(score.absolute.distance_m.std, 0, 1e-12);
}

TEST(ScoreTrajectory, SeesASingleJumpOnceInTheRelativeError)
{
    // From pose 20 on all is 1 m aside: one relative error of 1 m, all absolute ones from there on.
    const auto truth = random_walk(50, 9);
    auto estimate = truth;
    for (std::size_t i = 20; i < estimate.size(); ++i) estimate[i].pose.y += 1;
    const auto score = score_trajectory(estimate, truth, aligned_by(Alignment::None));
    EXPECT_NEAR(score.absolute.distance_m.sse, 30, 1e-9);
    EXPECT_NEAR(score.relative.at(0).distance_m.sse, 1, 1e-9);
    EXPECT_NEAR(score.relative.at(0).errors[19].distance_m, 1, 1e-12);
}

TEST(ScoreTrajectory, CountsWhatItWasGiven)
{
    const auto truth = random_walk(50, 10);
    auto estimate = truth;
    estimate.resize(30);
    const auto score = score_trajectory(estimate, truth);
    EXPECT_EQ(score.estimate_poses, 30u);
    EXPECT_EQ(score.reference_poses, 50u);
    EXPECT_EQ(score.matches.size(), 30u);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <near_pose.h>
#include <rtob/check/motion_steps.h>
#include <rtob/core/random.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rtob::test
{
namespace
{
/// Ahead, with turns that begin and end suddenly, both accounts the same.
MotionSteps drive(int scans)
{
    MotionSteps steps;
    Random random(7);
    double turn_rad = 0;
    for (int k = 0; k < scans; ++k)
    {
        if (k % 7 == 0) turn_rad = 0.2 * (random.uniform() - 0.5);
        const Pose2 step{0.1, 0, turn_rad};
        steps.push_back({step, step, true, true});
    }
    return steps;
}

MotionSteps with_odometry(MotionSteps steps, const std::function<Pose2(const Pose2&)>& change)
{
    for (auto& step : steps) step.odometry = change(step.odometry);
    return steps;
}

/// The odometry that many scans ahead of the laser.
MotionSteps ahead(const MotionSteps& steps, int scans)
{
    MotionSteps result = steps;
    for (int k = 0; k < static_cast<int>(steps.size()); ++k)
    {
        const int from = std::clamp(k + scans, 0, static_cast<int>(steps.size()) - 1);
        result[static_cast<std::size_t>(k)].odometry =
            steps[static_cast<std::size_t>(from)].odometry;
    }
    return result;
}

class TimeShiftOf : public testing::TestWithParam<int>
{
};

TEST_P(TimeShiftOf, WholeScansIsFoundAndUndone)
{
    const auto steps = ahead(drive(200), GetParam());
    const auto shift = find_time_shift(steps);
    ASSERT_TRUE(shift);
    EXPECT_NEAR(shift->scans, GetParam(), 1e-9);
    EXPECT_EQ(shift->sign, 1);
    // The ends repeat a step, and are not to be restored.
    const auto aligned = shifted(steps, *shift);
    for (std::size_t k = 3; k + 3 < aligned.size(); ++k)
        EXPECT_THAT(aligned[k].odometry, IsNearPose(aligned[k].laser, 1e-9, 1e-9)) << k;
}
INSTANTIATE_TEST_SUITE_P(MotionSteps, TimeShiftOf, testing::Values(-2, -1, 0, 1, 2));

TEST(MotionSteps, HalfAScanIsFound)
{
    auto steps = drive(200);
    for (std::size_t k = 1; k < steps.size(); ++k)
        steps[k].laser.yaw = (steps[k - 1].odometry.yaw + steps[k].odometry.yaw) / 2;
    const auto shift = find_time_shift(steps);
    ASSERT_TRUE(shift);
    EXPECT_NEAR(shift->scans, 0.5, 1e-9);
}

TEST(MotionSteps, TurnsTheOtherWayGiveTheSign)
{
    const auto shift = find_time_shift(with_odometry(
        drive(200),
        [](const Pose2& p) {
            return Pose2{p.x, p.y, -p.yaw};
        }));
    ASSERT_TRUE(shift);
    EXPECT_EQ(shift->sign, -1);
    EXPECT_NEAR(shift->scans, 0, 1e-9);
    EXPECT_NEAR(shift->agreement, 1, 1e-9);
}

TEST(MotionSteps, AStraightDriveTellsNoTime)
{
    MotionSteps steps(200, {{0.1, 0, 0}, {0.1, 0, 0}, true, true});
    EXPECT_FALSE(find_time_shift(steps));
    EXPECT_FALSE(fit_turns(steps));
}

TEST(MotionSteps, ScaleAndDriftAreToldApart)
{
    const auto fit = fit_turns(with_odometry(
        drive(2000),
        [](const Pose2& p) {
            return Pose2{p.x, p.y, 1.07 * p.yaw - 0.05 * p.x};
        }));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->scale.value, 1.07, 1e-6);
    EXPECT_NEAR(fit->drift_rad_per_m, -0.05, 1e-6);
}

TEST(MotionSteps, SlipsInATenthOfTheStretchesDoNotBendTheScale)
{
    auto steps = with_odometry(
        drive(2000),
        [](const Pose2& p) {
            return Pose2{p.x, p.y, 1.07 * p.yaw};
        });
    for (std::size_t k = 0; k < steps.size(); k += 300) steps[k].odometry.yaw += 2;
    const auto fit = fit_turns(steps);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->scale.value, 1.07, 0.01);
}

TEST(MotionSteps, TravelScaleCountsStraightMeasuredStretchesOnly)
{
    auto steps = drive(600);
    for (auto& step : steps)
    {
        step.laser.yaw = 0;
        step.odometry.x = 0.11;
    }
    for (std::size_t k = 0; k < 200; ++k)  // as along a corridor
    {
        steps[k].holds_position = false;
        steps[k].odometry.x = 0.5;
    }
    const auto scale = fit_travel(steps);
    ASSERT_TRUE(scale);
    EXPECT_NEAR(scale->value, 1.1, 1e-9);
}

TEST(MotionSteps, HeadingErrorsAreSplitIntoSteadyAndRandom)
{
    // 80 steps of 0.125 m are 10 m and 0.8 rad; 0, 0.2 or 0.4 rad more come at once.
    MotionSteps steps(9 * 80, {{0.125, 0, 0}, {0.125, 0, 0.01}, true, true});
    for (std::size_t stretch = 0; stretch < 9; ++stretch)
        steps[80 * stretch].odometry.yaw += 0.2 * static_cast<double>(stretch % 3);
    const auto errors = heading_errors(steps);
    ASSERT_TRUE(errors);
    EXPECT_NEAR(errors->steady_rad, 1.0, 1e-9);
    EXPECT_NEAR(errors->random_rad, 0.2, 1e-9);
    EXPECT_NEAR(errors->worst_rad, 1.2, 1e-9);
    EXPECT_FALSE(heading_errors(MotionSteps(50, {{0.1, 0, 0}, {}, true, true})));  // 5 m
}

TEST(MotionSteps, ReverseIsCountedByBoth)
{
    MotionSteps steps = drive(10);
    const auto back = [&](std::size_t k, double odometry_m)
    {
        steps[k].laser.x = -0.1;
        steps[k].odometry.x = odometry_m;
    };
    back(2, -0.1);
    back(3, 0.1);
    back(4, 0);
    steps[5].odometry.x = -0.1;  // the laser sees no step back
    const auto reverse = count_reverse(steps);
    EXPECT_EQ(reverse.laser, 3u);
    EXPECT_EQ(reverse.odometry, 1u);
    EXPECT_EQ(reverse.odometry_ever, 2u);
    EXPECT_EQ(reverse.forward, 1u);
    EXPECT_NEAR(reverse.forward_m, 0.1, 1e-12);
}

TEST(MotionSteps, TheMountsTurnIsThatOfTheOdometrySeenFromTheLaser)
{
    MotionSteps steps(
        50, {{0.1 * std::cos(-0.3), 0.1 * std::sin(-0.3), 0}, {0.1, 0, 0}, true, true});
    const auto turn = find_mount_turn(steps);
    ASSERT_TRUE(turn);
    EXPECT_NEAR(turn->value, 0.3, 1e-9);
    for (std::size_t k = 0; k < steps.size(); k += 2) steps[k].laser.x *= -1;
    EXPECT_FALSE(find_mount_turn(steps)) << "directions that disagree tell nothing";
}
}  // namespace
}  // namespace rtob::test

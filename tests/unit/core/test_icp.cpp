// SPDX-License-Identifier: BSD-3-Clause
// Laws, hand-computed figures and edges; whole worlds are in test_icp_worlds.cpp.
#include <gtest/gtest.h>
#include <near_pose.h>
#include <rtob/core/icp.h>
#include <rtob/core/random.h>
#include <worlds.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace rtob;
using rtob::test::IsNearPose;

namespace
{
IcpOptions line_options()
{
    IcpOptions options = test::paper_icp_options();
    options.metric = IcpMetric::PointToLine;
    return options;
}

Points points_of(const std::vector<std::pair<float, float>>& all)
{
    Points points;
    for (const auto& [x, y] : all) points.add(x, y);
    return points;
}

/// Two walls of 10 m, 2 m apart, points every 0.05 m, turned about the vehicle in the middle.
Points corridor(double direction_rad)
{
    Points points;
    for (int i = -100; i <= 100; ++i)
        for (const float y : {-1.0f, 1.0f}) points.add(0.05f * static_cast<float>(i), y);
    return test::moved(points, {0, 0, direction_rad});
}

test::Matching room_matching()
{
    const auto world = test::worlds()[0];
    Pose2 guess = world.pose_map_vehicle;
    guess.x += 0.15;
    guess.y -= 0.1;
    guess.yaw += 0.05;
    return test::matching(world, guess);
}

/// Leaves numbers on the stack below the caller, where its next call will keep its variables.
__attribute__((noinline)) void litter_stack(double litter)
{
    volatile double numbers[2048];
    for (auto& number : numbers) number = litter;
}

Points shuffled(const Points& points, Random& random)
{
    Points mixed = points;
    for (std::size_t i = points.size(); i-- > 1;)
    {
        const std::size_t j = random.below(i + 1);
        std::swap(mixed.x[i], mixed.x[j]);
        std::swap(mixed.y[i], mixed.y[j]);
    }
    return mixed;
}
}  // namespace

TEST(Icp, ErrorAndShareAreThoseComputedByHand)
{
    // The reference is the scan, 0.1 m farther out on all four sides: nothing can be gained, and
    // each of the four pairs is 0.1 m long. The fifth point has no neighbour.
    const Points scan = points_of({{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {5, 5}});
    const Points reference = points_of({{1.1f, 0}, {-1.1f, 0}, {0, 1.1f}, {0, -1.1f}});
    const auto result = Icp(test::paper_icp_options()).align(scan.view(), reference.view());
    EXPECT_THAT(result.correction, IsNearPose(Pose2{}, 1e-7, 1e-7));
    EXPECT_EQ(result.pairs, 4u);
    EXPECT_DOUBLE_EQ(result.paired_share, 0.8);
    EXPECT_NEAR(result.mean_squared_error, 0.01, 1e-7);
}

TEST(Icp, OneStepIsTheLeastSquaresMotion)
{
    // A turn of the square by 0.1 rad about its centre and a shift: the closed form finds both.
    const Points scan = points_of({{1, 1}, {1, -1}, {-1, 1}, {-1, -1}});
    const Pose2 truth{0.02, -0.03, 0.1};
    IcpOptions options = test::paper_icp_options();
    options.iterations = 1;
    const auto result = Icp(options).align(scan.view(), test::moved(scan, truth).view());
    EXPECT_THAT(result.correction, IsNearPose(truth, 1e-6, 1e-6));
    EXPECT_EQ(result.iterations, 1);
}

TEST(Icp, DoesAllIterationsUnlessToldToStop)
{
    const auto m = room_matching();
    EXPECT_EQ(
        Icp(test::paper_icp_options()).align(m.scan.view(), m.reference.view()).iterations, 50);
    IcpOptions stopping = test::paper_icp_options();
    stopping.stop_step_m = 1e-4;
    const auto result = Icp(stopping).align(m.scan.view(), m.reference.view());
    EXPECT_LT(result.iterations, 50);
    EXPECT_THAT(result.correction, IsNearPose(m.truth, 1e-3, 1e-3));
}

// Whatever was on the stack before: a starting point left open once made this a matter of luck.
TEST(Icp, StartsWhereTheReferenceIsSeenFromUnlessToldOtherwise)
{
    const auto m = room_matching();
    Icp icp(line_options());
    IcpReference reference;
    icp.prepare(m.reference.view(), reference);
    const auto told = icp.align(m.scan.view(), reference, Eigen::Vector2d::Zero());
    for (const double litter : {0.7, -3.0})
    {
        litter_stack(litter);
        const auto untold = icp.align(m.scan.view(), m.reference.view());
        EXPECT_EQ(untold.correction.x, told.correction.x);
        EXPECT_EQ(untold.correction.y, told.correction.y);
        EXPECT_EQ(untold.correction.yaw, told.correction.yaw);
    }
}

TEST(Icp, TheOrderOfPointsDoesNotMatter)
{
    const auto m = room_matching();
    Random random(1);
    for (const auto& options : {test::paper_icp_options(), line_options()})
    {
        Icp icp(options);
        const auto once = icp.align(m.scan.view(), m.reference.view());
        const auto mixed =
            icp.align(shuffled(m.scan, random).view(), shuffled(m.reference, random).view());
        EXPECT_THAT(mixed.correction, IsNearPose(once.correction, 1e-5, 1e-5));
        EXPECT_EQ(mixed.pairs, once.pairs);
        EXPECT_NEAR(mixed.mean_squared_error, once.mean_squared_error, 1e-8);
    }
}

TEST(Icp, ShiftsAndTurnsOfTheFrameCarryOver)
{
    const auto m = room_matching();
    for (const Pose2& frame : {Pose2{3, -2, 0}, Pose2{0, 0, 2.5}, Pose2{-1, 4, -1}})
        for (const auto& options : {test::paper_icp_options(), line_options()})
        {
            const auto here = Icp(options).align(m.scan.view(), m.reference.view());
            const auto there = Icp(options).align(
                test::moved(m.scan, frame).view(), test::moved(m.reference, frame).view());
            EXPECT_THAT(
                there.correction,
                IsNearPose(compose(compose(frame, here.correction), inverse(frame)), 1e-3, 1e-4));
        }
}

TEST(Icp, NothingToMatchLeavesTheGuess)
{
    const Points none, one = points_of({{1, 0}}), room = room_matching().reference;
    for (const auto& options : {test::paper_icp_options(), line_options()})
        for (const auto& [scan, reference] :
             {std::pair(none, none), std::pair(none, room), std::pair(room, none),
              std::pair(one, one), std::pair(one, room)})
        {
            const auto result = Icp(options).align(scan.view(), reference.view());
            EXPECT_THAT(result.correction, IsNearPose(Pose2{}, 0, 0));
            EXPECT_LE(result.paired_share, 1);
            EXPECT_TRUE(std::isfinite(result.mean_squared_error));
            EXPECT_TRUE(result.covariance.allFinite());
        }
}

TEST(Icp, ACorridorIsUncertainAlongItself)
{
    for (const double direction_rad : {0.0, 0.5, -1.2})
        for (const auto& options : {test::paper_icp_options(), line_options()})
        {
            const Points walls = corridor(direction_rad);
            const auto result = Icp(options).align(walls.view(), walls.view());
            ASSERT_TRUE(result.covariance.allFinite());
            const Eigen::Matrix2d position = result.covariance.topLeftCorner<2, 2>();
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(position);
            EXPECT_GE(axes.eigenvalues()(1), 10 * 10 * axes.eigenvalues()(0));
            const Eigen::Vector2d along(std::cos(direction_rad), std::sin(direction_rad));
            EXPECT_GT(std::abs(axes.eigenvectors().col(1).dot(along)), 0.999);
        }
}

TEST(Icp, TheNoiseOfBareWallsFeignsNoKnowledgeAlongThem)
{
    Random random(3);
    std::vector<Points> noisy(2, corridor(0));
    for (Points& points : noisy)
        for (float& y : points.y) y += 0.02f * static_cast<float>(random.uniform() - 0.5);
    const auto result = Icp(line_options()).align(noisy[0].view(), noisy[1].view());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
        result.covariance.topLeftCorner<2, 2>().eval());
    EXPECT_GT(std::sqrt(axes.eigenvalues()(1)), 10.0);
    EXPECT_GT(result.information(0, 0), 0.01) << "of which nothing is left";
    // 402 pairs of at least 1 cm, four of which count as one.
    EXPECT_NEAR(0.01 / std::sqrt(402 / 4.0), std::sqrt(axes.eigenvalues()(0)), 1e-4);
}

TEST(Icp, TheWeakDirectionIsAlongTheCorridor)
{
    for (const double direction_rad : {0.0, 0.5, -1.2})
    {
        const Points walls = corridor(direction_rad);
        const auto result = Icp(line_options()).align(walls.view(), walls.view());
        const WeakDirection weak = weak_direction(result.information);
        EXPECT_NEAR(weak.share, 0, 1e-6);
        EXPECT_NEAR(weak.angle_rad, direction_rad, 1e-3);
    }
    EXPECT_EQ(weak_direction(Eigen::Matrix3d::Zero()).share, 0.5) << "nothing is weaker than all";
    const WeakDirection of_two = weak_direction(Eigen::Vector3d(30, 10, 1).asDiagonal());
    EXPECT_NEAR(of_two.share, 0.25, 1e-12);
    EXPECT_NEAR(std::abs(of_two.angle_rad), 1.5707963, 1e-6);
}

TEST(Icp, ARoomIsCertainInAllDirections)
{
    const auto m = room_matching();
    const auto result = Icp(test::paper_icp_options()).align(m.scan.view(), m.reference.view());
    EXPECT_LT(result.covariance(0, 0), 10 * result.covariance(1, 1));
    EXPECT_LT(result.covariance(1, 1), 10 * result.covariance(0, 0));
    EXPECT_TRUE(result.covariance.isApprox(result.covariance.transpose()));
}

TEST(Icp, APriorHoldsTheDirectionThatTheWallsLeaveOpen)
{
    // The guess is off by 0.02 m along the corridor, less than half the points' step, and 0.1 m
    // across: left alone, the points pull both to 0.
    const Points reference = corridor(0), scan = test::moved(reference, {0.02, 0.1, 0});
    IcpOptions unheld = line_options();
    unheld.weak_share = 0;
    const auto free = Icp(unheld).align(scan.view(), reference.view());
    EXPECT_THAT(free.correction, IsNearPose(Pose2{-0.02, -0.1, 0}, 2e-3, 1e-3));
    CorrectionPrior prior;
    prior.information(0, 0) = 1e3;
    for (const auto& options : {test::paper_icp_options(), line_options()})
    {
        const auto held = Icp(options).align(scan.view(), reference.view(), prior);
        EXPECT_NEAR(held.correction.y, -0.1, 2e-3);
        // 402 points pull along with at most 1 each, the prior with 1000.
        EXPECT_LT(std::abs(held.correction.x), 0.02 * 402 / 1402.0 + 1e-3);
    }
}

TEST(Icp, TheGuessHoldsTheDirectionThatTheWallsLeaveOpen)
{
    // A corridor in any direction, and a few points of someone who has walked on by 0.15 m since.
    for (const double direction_rad : {0.0, 0.6, -1.4})
    {
        Points reference = corridor(0), scan = corridor(0);
        for (int i = 0; i < 8; ++i)
        {
            const float y = 0.05f * static_cast<float>(i - 4);
            reference.add(1.0f, y);
            scan.add(1.15f, y);
        }
        reference = test::moved(reference, {0, 0, direction_rad});
        scan = test::moved(scan, {0, 0, direction_rad});
        const auto along_m = [&](double weak_share)
        {
            IcpOptions options = line_options();
            options.weak_share = weak_share;
            const auto fit = Icp(options).align(scan.view(), reference.view());
            return std::cos(direction_rad) * fit.correction.x +
                   std::sin(direction_rad) * fit.correction.y;
        };
        EXPECT_LT(along_m(0), -0.1);
        EXPECT_NEAR(along_m(0.1), 0, 0.05);
    }
}

TEST(Icp, ARoomNeedsNoHold)
{
    const auto m = room_matching();
    IcpOptions unheld = line_options();
    unheld.weak_share = 0;
    const auto held = Icp(line_options()).align(m.scan.view(), m.reference.view());
    const auto free = Icp(unheld).align(m.scan.view(), m.reference.view());
    EXPECT_THAT(held.correction, IsNearPose(free.correction, 1e-12, 1e-12));
}

TEST(IcpOptions, RefusesWhatIsOutOfRange)
{
    const auto refused = [](const auto& change)
    {
        IcpOptions options = test::paper_icp_options();
        change(options);
        EXPECT_THROW(Icp{options}, std::invalid_argument);
    };
    refused([](auto& o) { o.iterations = 0; });
    refused([](auto& o) { o.max_pair_distance_m = 0; });
    refused([](auto& o) { o.final_pair_distance_m = 0.31; });
    refused([](auto& o) { o.final_pair_distance_m = 0; });
    refused([](auto& o) { o.kernel_scale_m = 0; });
    refused([](auto& o) { o.line_radius_m = 0.31; });
    refused([](auto& o) { o.stop_step_m = -1; });
    refused([](auto& o) { o.weak_share = 0.51; });
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/pose_belief.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace
{
using rtob::FusionOptions;
using rtob::PoseBelief;

constexpr double kStep_s = 0.1;
const Eigen::Vector2d kStands(0, 0);

Eigen::Matrix3d match(double sigma_x_m, double sigma_y_m = 0.005, double sigma_yaw_rad = 0.002)
{
    return Eigen::Vector3d(sigma_x_m, sigma_y_m, sigma_yaw_rad)
        .array()
        .square()
        .matrix()
        .asDiagonal();
}

const Eigen::Matrix3d kTold = match(0.005);
const Eigen::Matrix3d kCertain = Eigen::Matrix3d::Zero();
const Eigen::Matrix3d kOpenAlongX = match(1000);

void drive(PoseBelief& belief, int scans, const Eigen::Matrix3d& covariance)
{
    for (int i = 0; i < scans; ++i)
    {
        belief.advance(kStep_s, {0.07, 0}, false);
        belief.matched(covariance);
        belief.inserted();
    }
}

double sigma(const Eigen::Matrix3d& covariance, int axis)
{
    return std::sqrt(covariance(axis, axis));
}
}  // namespace

TEST(PoseBelief, ForgottenItIsWorthItsNextMatch)
{
    PoseBelief belief;
    belief.forget();
    const Eigen::Matrix3d match = Eigen::Vector3d(1e-4, 4e-4, 1e-5).asDiagonal();
    belief.matched(match);
    EXPECT_TRUE(belief.inMap().isApprox(match, 1e-3));
}

TEST(PoseBelief, IsCertainWhereTheMapBegins)
{
    EXPECT_TRUE(PoseBelief().inMap().isZero());
    EXPECT_TRUE(PoseBelief().inLocalMap().isZero());
}

TEST(PoseBelief, GrowsWithTheVelocityThatNobodyKnows)
{
    FusionOptions noises;
    noises.speed_change_mps = 2;
    PoseBelief belief(noises);
    belief.advance(0.5, kStands, false);
    // 4 (m/s)^2 at first and 4 (m/s)^2 a second, carried on for 0.5 s.
    EXPECT_NEAR((4 + 4 * 0.5) * 0.5 * 0.5, belief.inMap()(0, 0), 1e-12);
    EXPECT_NEAR(belief.inMap()(0, 0), belief.inLocalMap()(0, 0), 1e-12);
}

TEST(PoseBelief, IsNoWorseThanTheMatch)
{
    PoseBelief belief;
    drive(belief, 50, kTold);
    for (const int axis : {0, 1, 2})
    {
        EXPECT_LT(sigma(belief.inLocalMap(), axis), sigma(kTold, axis));
        EXPECT_GT(sigma(belief.inLocalMap(), axis), 0.5 * sigma(kTold, axis));
    }
}

TEST(PoseBelief, DriftsFromTheBeginningOfTheMapAlthoughEveryMatchIsGood)
{
    PoseBelief belief;
    drive(belief, 100, kTold);
    const double after_7m = sigma(belief.inMap(), 0);
    drive(belief, 100, kTold);
    EXPECT_GT(sigma(belief.inMap(), 0), 1.3 * after_7m) << "as the root of the way";
    EXPECT_LT(sigma(belief.inMap(), 0), 1.6 * after_7m);
    EXPECT_GT(sigma(belief.inMap(), 1), 3 * sigma(belief.inMap(), 0)) << "the heading drifts, too";
}

TEST(PoseBelief, GrowsAlongACorridorThatSaysNothing)
{
    PoseBelief belief;
    drive(belief, 10, kTold);
    drive(belief, 100, kOpenAlongX);
    EXPECT_GT(sigma(belief.inMap(), 0), 5);  // 10 s at 1 m/s after 1 s: 18 m by the formula
    EXPECT_LT(sigma(belief.inMap(), 0), 20);
    EXPECT_GT(sigma(belief.inLocalMap(), 0), 10 * sigma(belief.inLocalMap(), 1));
}

TEST(PoseBelief, TellsTheLocalMapFromTheMapAfterACorridor)
{
    PoseBelief belief;
    drive(belief, 10, kTold);
    drive(belief, 100, kOpenAlongX);
    const double lost_m = sigma(belief.inMap(), 0);
    drive(belief, 20, kTold);
    EXPECT_LT(sigma(belief.inLocalMap(), 0), sigma(kTold, 0)) << "the end wall tells";
    EXPECT_GT(sigma(belief.inMap(), 0), 0.5 * lost_m) << "but it was written where it seemed to be";
    belief.held(kTold, kCertain);
    EXPECT_LT(sigma(belief.inMap(), 0), 1.01 * sigma(kTold, 0)) << "old scans tell both";
    drive(belief, 1, kTold);
    EXPECT_LT(sigma(belief.inMap(), 0), 2 * sigma(kTold, 0)) << "and the local map with it";
}

TEST(PoseBelief, IsNoMoreCertainThanTheOldScansThatHoldIt)
{
    PoseBelief belief;
    drive(belief, 100, kTold);
    const Eigen::Matrix3d old = match(0.04, 0.03, 0.01);
    for (int i = 0; i < 50; ++i)
    {
        drive(belief, 1, kTold);
        belief.held(kTold, old);
    }
    for (const int axis : {0, 1, 2})
    {
        EXPECT_GE(sigma(belief.inMap(), axis), sigma(old, axis)) << axis;
        EXPECT_LT(sigma(belief.inMap(), axis), 1.2 * sigma(old, axis)) << axis;
        EXPECT_LT(sigma(belief.inLocalMap(), axis), sigma(kTold, axis)) << axis;
    }
}

TEST(PoseBelief, FoundAgainItKnowsItsPlaceInTheMapAndNotWhereThatIs)
{
    PoseBelief belief;
    belief.forget(match(0.04));
    belief.matched(kTold);
    EXPECT_NEAR(sigma(belief.inMap(), 0), std::hypot(0.04, 0.005), 1e-5);
    EXPECT_NEAR(sigma(belief.inLocalMap(), 0), 0.005, 1e-5);
}

TEST(PoseBelief, GrowsByOdometryAsTheRootOfTheWay)
{
    FusionOptions noises;
    noises.odometry_noise_m = 0.02;
    PoseBelief belief(noises);
    for (int i = 0; i < 100; ++i) belief.advance(kStep_s, {0.04, 0}, true);
    EXPECT_NEAR(0.04, sigma(belief.inMap(), 0), 0.01);  // 0.02 m after 1 m: 0.04 m after 4 m
    EXPECT_GT(sigma(belief.inMap(), 1), sigma(belief.inMap(), 0)) << "the heading drifts, too";
}

TEST(PoseBelief, StaysACovarianceWhateverComes)
{
    PoseBelief belief;
    for (int i = 0; i < 2000; ++i)
    {
        belief.advance(i % 7 == 0 ? 0.0 : 0.3, {0.5 * std::cos(i), 0.5 * std::sin(i)}, i % 5 == 0);
        if (i % 3 != 0) belief.matched(i % 4 == 0 ? kOpenAlongX : match(1e-4, 1e-4, 1e-5));
        if (i % 200 == 0) belief.held(kTold, kCertain);
        if (i % 300 == 0) belief.held(kOpenAlongX, match(0.1));
        if (i % 2 == 0) belief.inserted();
        for (const Eigen::Matrix3d& covariance : {belief.inMap(), belief.inLocalMap()})
        {
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
            ASSERT_GE(axes.eigenvalues()(0), -1e-9 * axes.eigenvalues()(2)) << i;
            ASSERT_NEAR(covariance(0, 1), covariance(1, 0), 1e-6 * axes.eigenvalues()(2)) << i;
        }
    }
}

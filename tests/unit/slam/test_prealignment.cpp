// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/prealignment.h>
#include <Eigen/Geometry>

#include <limits>
#include <stdexcept>

#include "near_pose.h"

using rtob::Pose2;
using rtob::Prealignment;
using rtob::PrealignOptions;
using rtob::PrealignSource;
using rtob::test::IsNearPose;

namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double kExact = 1e-12;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Two matched scans 0.1 s apart: 20 cm ahead and 0.02 rad to the left between them.
Prealignment driving(PrealignSource source, PrealignOptions options = {})
{
    options.source = source;
    Prealignment prealignment(options);
    const Pose2 first{1, 2, pi / 2};
    prealignment.settle(10.0, first, true);
    prealignment.settle(10.1, compose(first, {0.2, 0, 0.02}), true);
    return prealignment;
}

const Pose2 pose_map_last{1, 2.2, pi / 2 + 0.02};
}  // namespace

TEST(Prealignment, StartsAtTheOrigin)
{
    for (const auto source :
         {PrealignSource::Auto, PrealignSource::LastPose, PrealignSource::ConstantVelocity,
          PrealignSource::Odometry})
        EXPECT_THAT(Prealignment({source}).predict(5), IsNearPose(Pose2{}, 0.0, 0.0));
}

TEST(Prealignment, ByLastPoseStaysThere)
{
    auto prealignment = driving(PrealignSource::LastPose);
    prealignment.addMotion({1, 1, 1});
    EXPECT_THAT(prealignment.predict(10.2), IsNearPose(pose_map_last, kExact, kExact));
}

TEST(Prealignment, ByConstantVelocityGoesOnInTheVehicleFrame)
{
    const auto prealignment = driving(PrealignSource::ConstantVelocity);
    const Pose2 one_step = compose(pose_map_last, {0.2, 0, 0.02});
    EXPECT_THAT(prealignment.predict(10.2), IsNearPose(one_step, 1e-9, 1e-9));
    const Pose2 half_a_step = compose(pose_map_last, {0.1, 0, 0.01});
    EXPECT_THAT(prealignment.predict(10.15), IsNearPose(half_a_step, 1e-9, 1e-9));
}

TEST(Prealignment, TakesTheUsualStepWhereTheStampSaysNothing)
{
    // Repeated, stepped back, none, a second ahead, a day ahead.
    const auto prealignment = driving(PrealignSource::ConstantVelocity);
    const Pose2 one_step = compose(pose_map_last, {0.2, 0, 0.02});
    for (const double stamp_s : {10.1, 10.0, -1e9, not_a_number, 11.11, 10.1 + 86400})
        EXPECT_THAT(prealignment.predict(stamp_s), IsNearPose(one_step, 1e-9, 1e-9)) << stamp_s;
}

TEST(Prealignment, AStampThatStepsBackAndForthChangesNoStep)
{
    auto prealignment = driving(PrealignSource::ConstantVelocity);
    const Pose2 step{0.2, 0, 0.02};
    Pose2 pose = pose_map_last;
    for (const double stamp_s : {10.2, 9.4, 10.4, 10.5, 10.5, 10.7})  // ten a second
    {
        pose = compose(pose, step);
        EXPECT_THAT(prealignment.predict(stamp_s), IsNearPose(pose, 1e-9, 1e-9)) << stamp_s;
        prealignment.settle(stamp_s, pose, true);
    }
}

TEST(Prealignment, StampsThatJitterThrowNoGuessAway)
{
    // Ten scans a second, which a loaded computer stamped in bursts. The slow turn over a
    // thousandth of a second would be one of 5 rad/s.
    auto prealignment = driving(PrealignSource::ConstantVelocity);
    const Pose2 step{0.004, 0, 0.005};
    Pose2 pose = pose_map_last;
    for (const double stamp_s : {10.2, 10.299, 10.300, 10.301, 10.502, 10.503, 10.701})
    {
        pose = compose(pose, step);
        if (stamp_s > 10.25)  // the turn of driving() has left the velocity
        {
            // At most twice the usual step, over at least half of it.
            EXPECT_THAT(prealignment.predict(stamp_s), IsNearPose(pose, 0.0125, 0.0155)) << stamp_s;
        }
        prealignment.settle(stamp_s, pose, true);
    }
}

TEST(Prealignment, AfterAPauseTheVehicleIsTakenToStand)
{
    auto prealignment = driving(PrealignSource::ConstantVelocity);
    prealignment.settle(20, {5, 6, 0}, true);
    EXPECT_THAT(prealignment.predict(20.1), IsNearPose(Pose2{5, 6, 0}, kExact, kExact));
}

TEST(Prealignment, AScanWithoutAMatchEndsTheMotion)
{
    auto prealignment = driving(PrealignSource::ConstantVelocity);
    prealignment.settle(10.2, pose_map_last, false);
    EXPECT_THAT(prealignment.predict(10.3), IsNearPose(pose_map_last, kExact, kExact));
}

TEST(Prealignment, AMotionTooFastToBeTrueIsNotCarriedOn)
{
    PrealignOptions slow;
    slow.max_speed_mps = 1.9;  // it drives 2 m/s
    EXPECT_THAT(
        driving(PrealignSource::ConstantVelocity, slow).predict(10.2),
        IsNearPose(pose_map_last, kExact, kExact));
    PrealignOptions steady;
    steady.max_turn_degps = 11;  // it turns 0.2 rad/s, 11.5 deg/s
    EXPECT_THAT(
        driving(PrealignSource::ConstantVelocity, steady).predict(10.2),
        IsNearPose(pose_map_last, kExact, kExact));
}

TEST(Prealignment, ByOdometryAddsWhatItMovedSinceTheLastScan)
{
    for (const auto source : {PrealignSource::Auto, PrealignSource::Odometry})
    {
        Prealignment prealignment({source});
        prealignment.addOdometry({50, 60, 0});  // where odometry began does not matter
        prealignment.settle(10.0, {1, 2, pi / 2}, true);
        prealignment.addOdometry({50.1, 60, 0});
        prealignment.addOdometry({50.3, 60, 0.1});
        EXPECT_THAT(
            prealignment.predict(10.1), IsNearPose(Pose2{1, 2.3, pi / 2 + 0.1}, 1e-9, 1e-9));
    }
}

TEST(Prealignment, AddsUpMotions)
{
    Prealignment prealignment;
    prealignment.settle(10.0, {1, 2, pi / 2}, true);
    prealignment.addMotion({0.1, 0, 0});
    EXPECT_THAT(prealignment.predict(10.1), IsNearPose(Pose2{1, 2.1, pi / 2}, 1e-9, 1e-9));
    prealignment.settle(10.1, {1, 2.1, pi / 2}, true);
    prealignment.addMotion({0.1, 0, pi / 2});
    prealignment.addMotion({0.2, 0, 0});
    // 10 cm ahead (up the map), a quarter turn to the left, 20 cm ahead (down the map's x).
    EXPECT_THAT(prealignment.predict(10.2), IsNearPose(Pose2{0.8, 2.2, pi}, 1e-9, 1e-9));
}

TEST(Prealignment, MotionBeforeTheFirstScanIsNoStepOfTheMap)
{
    Prealignment prealignment;
    prealignment.addOdometry({5, 5, 1});
    prealignment.addOdometry({7, 5, 2});
    EXPECT_THAT(prealignment.predict(10), IsNearPose(Pose2{}, kExact, kExact));
}

TEST(Prealignment, WithoutFreshOdometryAutoFallsBackToTheVelocity)
{
    const auto with_old_odometry = [](PrealignSource source)
    {
        Prealignment prealignment({source});
        prealignment.addOdometry({0, 0, 0});
        prealignment.settle(10.0, {0, 0, 0}, true);
        prealignment.addOdometry({0.2, 0, 0});
        prealignment.settle(10.1, {0.2, 0, 0}, true);
        return prealignment.predict(10.2);
    };
    EXPECT_THAT(with_old_odometry(PrealignSource::Auto), IsNearPose(Pose2{0.4, 0, 0}, 1e-9, 1e-9));
    EXPECT_THAT(
        with_old_odometry(PrealignSource::Odometry), IsNearPose(Pose2{0.2, 0, 0}, kExact, kExact));
}

TEST(Prealignment, OdometryThatIsNoNumberIsPassedOver)
{
    Prealignment prealignment;
    prealignment.addOdometry({0, 0, 0});
    prealignment.settle(10.0, {1, 2, 0}, true);
    prealignment.addOdometry({0.1, 0, 0});
    prealignment.addOdometry({not_a_number, 0, 0});
    prealignment.addMotion({0, std::numeric_limits<double>::infinity(), 0});
    prealignment.addMotion({0, 0, not_a_number});
    EXPECT_THAT(prealignment.predict(10.1), IsNearPose(Pose2{1.1, 2, 0}, 1e-9, 1e-9));
    prealignment.addMotion({0.1, 0, 0});
    EXPECT_THAT(prealignment.predict(10.1), IsNearPose(Pose2{1.2, 2, 0}, 1e-9, 1e-9));
}

TEST(Prealignment, AResetPutsTheVehicleElsewhereAtRest)
{
    auto prealignment = driving(PrealignSource::Auto);
    prealignment.addMotion({0.5, 0, 0});
    prealignment.reset({7, 8, 0});
    EXPECT_THAT(prealignment.predict(10.2), IsNearPose(Pose2{7, 8, 0}, kExact, kExact));
    prealignment.addMotion({0.5, 0, 0});
    EXPECT_THAT(prealignment.predict(10.2), IsNearPose(Pose2{7.5, 8, 0}, 1e-9, 1e-9));
}

TEST(Prealignment, KnowsWhetherThereIsOdometry)
{
    Prealignment prealignment;
    EXPECT_FALSE(prealignment.hasOdometry());
    prealignment.addMotion({});
    EXPECT_TRUE(prealignment.hasOdometry());
}

TEST(PrealignOptions, RefusesValuesOutOfRange)
{
    EXPECT_THROW(Prealignment({PrealignSource::Auto, 0, 360}), std::invalid_argument);
    EXPECT_THROW(Prealignment({PrealignSource::Auto, 5, -1}), std::invalid_argument);
}

TEST(Prealignment, TakesOverOfAVelocityWhatIsBelieved)
{
    auto prealignment = driving(PrealignSource::ConstantVelocity);  // heads for y, 2 m/s
    Eigen::Matrix3d believed = Eigen::Matrix3d::Identity();
    believed(1, 1) = 0.25;  // of what is new along the map's y
    const Pose2 stopped = compose(pose_map_last, {0.0, 0.1, 0.02});
    prealignment.settle(10.2, stopped, true, believed);
    const Pose2 step = between(stopped, prealignment.predict(10.3));
    // The vehicle looks along y but for 0.02 rad: 2 m/s of before, a quarter of what was lost.
    EXPECT_NEAR(0.15, step.x, 0.005);
    EXPECT_NEAR(0.1, step.y, 0.005);
    EXPECT_NEAR(0.02, step.yaw, 1e-9);
}

TEST(Prealignment, ACorrectionIsNoVelocity)
{
    auto prealignment = driving(PrealignSource::ConstantVelocity);
    const Pose2 corrected{1.3, 2.2, pose_map_last.yaw};  // old scans: 0.3 m to the side
    prealignment.correct(corrected);
    const Pose2 one_step = compose(corrected, {0.2, 0, 0.02});
    EXPECT_THAT(prealignment.predict(10.2), IsNearPose(one_step, 1e-9, 1e-9));
}

TEST(Prealignment, BelievesTheVelocityThatAMatchShowsButAlongABareCorridor)
{
    rtob::IcpResult fit;
    EXPECT_TRUE(rtob::velocity_shown(fit).isIdentity()) << "nothing says otherwise";
    fit.pairs = 200;
    const auto shown_along_x = [&](double information_of_a_pair)
    {
        fit.information = Eigen::Vector3d(200 * information_of_a_pair, 200, 200).asDiagonal();
        return rtob::velocity_shown(fit)(0, 0);
    };
    EXPECT_GT(shown_along_x(0.1), 0.999) << "a room";
    EXPECT_GT(shown_along_x(1e-3), 0.99) << "a corridor with doors";
    EXPECT_NEAR(0.5, shown_along_x(2e-4), 1e-3);
    EXPECT_LT(shown_along_x(7.5e-5), 0.03) << "the noise of bare walls";
    const Eigen::Matrix3d shown = rtob::velocity_shown(fit);
    EXPECT_NEAR(1, shown(1, 1), 1e-12);
    EXPECT_NEAR(1, shown(2, 2), 1e-12);

    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
    fit.information.topLeftCorner<2, 2>() =
        turn * fit.information.topLeftCorner<2, 2>() * turn.transpose();
    const Eigen::Matrix2d turned = rtob::velocity_shown(fit).topLeftCorner<2, 2>();
    EXPECT_TRUE(turned.isApprox(turn * shown.topLeftCorner<2, 2>() * turn.transpose(), 1e-6));
}

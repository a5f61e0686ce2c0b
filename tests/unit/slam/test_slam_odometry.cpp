// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/map/conversions.h>
#include <rtob/slam/slam.h>

#include <functional>

#include "drive_log.h"
#include "near_pose.h"

using namespace rtob;
using test::IsNearPose;

namespace
{
constexpr int kScans = 25;

/// Stands in the room, and jerks around by 75 degrees from scan to scan, now left, now right.
Pose2 pose_at(int scan)
{
    constexpr double turn_rad = 75 * 3.14159265358979323846 / 180;
    const int turns[] = {0, 1, 0, 1, 2, 1, 0, -1, 0, 1};
    return {1.5 + 0.02 * scan, 1.2, wrap_angle(turn_rad * turns[scan % 10])};
}

mrpt::obs::CObservation2DRangeScan scan_at(int scan)
{
    return test::scan_observation(
        test::room_4x3(), pose_at(scan), 1000 + 0.1 * scan, test::mrpt_laser());
}

/// Odometry counts from a place of its own and is off by 2 % and 2 degrees a step.
Pose2 odometry_step(int scan)
{
    const Pose2 step = between(pose_at(scan - 1), pose_at(scan));
    return {1.02 * step.x, 1.02 * step.y, step.yaw + 0.035};
}

/// @param tell hands the odometry up to this scan to the pipeline.
/// @return how many scans were tracked at the right place.
int tracked_scans(Slam& slam, const std::function<void(Slam&, int)>& tell)
{
    int tracked = 0;
    for (int k = 0; k < kScans; ++k)
    {
        tell(slam, k);
        const ScanReport& report = slam.process(scan_at(k));
        const Pose2 error = between(between(pose_at(0), pose_at(k)), report.pose_map_vehicle);
        tracked += report.state == TrackingState::Tracking && std::abs(error.x) < 0.02 &&
                   std::abs(error.y) < 0.02 && std::abs(error.yaw) < 0.02;
    }
    return tracked;
}

SlamOptions without_search()
{
    SlamOptions options;
    options.search.enabled = false;
    return options;
}
}  // namespace

TEST(SlamOdometry, AsObservationsCarriesFastTurns)
{
    Pose2 pose_odom_vehicle{-5, 7, 2};
    const auto tell = [&](Slam& slam, int k)
    {
        if (k > 0) pose_odom_vehicle = compose(pose_odom_vehicle, odometry_step(k));
        mrpt::obs::CObservationOdometry odometry;
        odometry.odometry = to_cpose2d(pose_odom_vehicle);
        EXPECT_EQ(slam.observe(odometry), nullptr);
    };
    Slam slam(without_search());
    EXPECT_EQ(tracked_scans(slam, tell), kScans);
    EXPECT_TRUE(slam.hasOdometry());
}

TEST(SlamOdometry, AsActionsCarriesFastTurns)
{
    const auto tell = [](Slam& slam, int k)
    {
        if (k == 0) return;
        mrpt::obs::CActionRobotMovement2D motion;
        motion.computeFromOdometry(to_cpose2d(odometry_step(k)), {});
        slam.observe(motion);
    };
    Slam slam(without_search());
    EXPECT_EQ(tracked_scans(slam, tell), kScans);
    EXPECT_TRUE(slam.hasOdometry());
}

TEST(SlamOdometry, WithoutItFastTurnsAreLost)
{
    Slam slam(without_search());
    EXPECT_LT(tracked_scans(slam, [](Slam&, int) {}), kScans / 2);
    EXPECT_FALSE(slam.hasOdometry());
}

TEST(SlamOdometry, MaySlipSomeScansLong)
{
    // The wheels stand still for five scans of the circle.
    Slam slam;
    for (int k = 0; k < 40; ++k)
    {
        slam.observe(*test::odometry_on_circle(k >= 10 && k < 15 ? 10 : k));
        EXPECT_EQ(slam.process(*test::scan_on_circle(k)).state, TrackingState::Tracking) << k;
        EXPECT_THAT(slam.pose(), IsNearPose(test::pose_on_circle_map(k), 0.01, 0.01)) << k;
    }
}

TEST(SlamOdometry, BoundsHowFarASearchMayMoveTheVehicle)
{
    // A scan that fits the map well, 1.7 m from where the wheels can have brought the vehicle: it
    // is believed where nothing else is known, and not against the odometry.
    for (const bool with_odometry : {false, true})
    {
        SlamOptions options;
        options.search.half_width_m = 2;
        Slam slam(options);
        for (int k = 0; k < 20; ++k)
        {
            if (with_odometry) slam.observe(*test::odometry_on_circle(k));
            ASSERT_EQ(slam.process(*test::scan_on_circle(k)).state, TrackingState::Tracking) << k;
        }
        if (with_odometry) slam.observe(*test::odometry_on_circle(19));
        Pose2 elsewhere = test::pose_on_circle(19);
        elsewhere.x += 1.7;
        const auto scan = test::scan_observation(
            test::room_4x3(), elsewhere, test::drive_start_s + 2.0, test::mrpt_laser());
        slam.process(scan);
        const Pose2 jump = between(test::pose_on_circle_map(19), slam.pose());
        if (with_odometry)
            EXPECT_LT(std::hypot(jump.x, jump.y), 1.0);
        else
            EXPECT_NEAR(std::hypot(jump.x, jump.y), 1.7, 0.05);
    }
}

TEST(SlamOdometry, ThatIsNoNumberDoesNoHarm)
{
    mrpt::obs::CObservationOdometry broken;
    broken.odometry = mrpt::poses::CPose2D(std::nan(""), 0, 0);
    Slam slam;
    for (int k = 0; k < 20; ++k)
    {
        slam.observe(*test::odometry_on_circle(k));
        if (k % 5 == 2) slam.observe(broken);
        EXPECT_EQ(slam.process(*test::scan_on_circle(k)).state, TrackingState::Tracking) << k;
    }
    EXPECT_THAT(slam.pose(), IsNearPose(test::pose_on_circle_map(19), 0.01, 0.01));
}

TEST(Slam, PassesOverOtherObservations)
{
    Slam slam;
    EXPECT_EQ(slam.observe(mrpt::obs::CObservationIMU()), nullptr);
    EXPECT_FALSE(slam.hasOdometry());
    EXPECT_EQ(slam.state(), TrackingState::Init);
}

TEST(SlamOdometry, WhatSlipsOnceDoesNotHoldTheVehicle)
{
    // It goes back and forth, and odometry has been right for long; then the floor carries it 0.3 m
    // on.
    const auto pose_odom_at = [](int k) { return Pose2{0.05 * (k % 2), 0, 0}; };
    constexpr int kRight = 600;
    Slam slam;
    Pose2 pose_room_vehicle;
    for (int k = 0; k < kRight + 3; ++k)
    {
        const Pose2 pose_room_odom{k < kRight ? 1.5 : 1.8, 1.2, 0};
        pose_room_vehicle = compose(pose_room_odom, pose_odom_at(k));
        mrpt::obs::CObservationOdometry odometry;
        odometry.odometry = to_cpose2d(pose_odom_at(k));
        (void)slam.observe(odometry);
        slam.process(test::scan_observation(
            test::room_4x3(), pose_room_vehicle, 1000 + 0.1 * k, test::mrpt_laser()));
    }
    EXPECT_EQ(slam.state(), TrackingState::Tracking);
    EXPECT_THAT(slam.pose(), IsNearPose(between({1.5, 1.2, 0}, pose_room_vehicle), 0.02, 0.01));
}

// SPDX-License-Identifier: BSD-3-Clause
// Whole logs whose odometry has one fault each: it is found, and nothing else is.
#include <check_drive.h>
#include <gmock/gmock.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>

namespace rtob::test
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;
using testing::HasSubstr;

/// Turns begin and end with a jerk: that shows delays.
int stop_and_go(int scan)
{
    return 20 * (scan / 20) + std::min(20, 2 * (scan % 20));
}

TEST(OdometryOfALog, NoOdometry)
{
    CheckDrive drive;
    drive.has_odometry = false;
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "WARN odometry.source");
    EXPECT_EQ(report.find("odometry.lag"), nullptr);
}

TEST(OdometryOfALog, OdometryThatStandsStill)
{
    CheckDrive drive;
    drive.odometry = [](const Pose2&) { return Pose2{}; };
    const auto report = check_drive(drive);
    EXPECT_THAT(troubles(report), HasSubstr("FAIL odometry.source"));
    EXPECT_THAT(report.ini(), HasSubstr("[Run]\n"));
    EXPECT_THAT(report.ini(), HasSubstr("use_odometry = false\n"));
}

TEST(OdometryOfALog, OdometryOfAnotherDrive)
{
    CheckDrive drive;
    int step = 0;
    drive.odometry = [&](const Pose2& true_step) {
        return Pose2{true_step.x, 0, 0.1 * std::sin(0.13 * ++step)};
    };
    const auto report = check_drive(drive);
    EXPECT_THAT(troubles(report), HasSubstr("FAIL odometry.lag"));
    EXPECT_THAT(report.ini(), HasSubstr("use_odometry = false\n"));
}

TEST(OdometryOfALog, ALaserThatComesLate)
{
    CheckDrive drive;
    drive.place = stop_and_go;
    drive.odometry_ahead_scans = 2;
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "WARN odometry.lag");
    EXPECT_NEAR(figure(report, "odometry.lag", "laser_after_odometry_scans"), 2, 0.2);
    EXPECT_NEAR(figure(report, "odometry.lag", "laser_after_odometry_s"), 0.2, 0.02);
    EXPECT_THAT(report.find("odometry.lag")->text, HasSubstr("after the odometry"));
}

TEST(OdometryOfALog, OdometryThatComesLate)
{
    CheckDrive drive;
    drive.place = stop_and_go;
    drive.odometry_ahead_scans = -1;
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "WARN odometry.lag");
    EXPECT_NEAR(figure(report, "odometry.lag", "laser_after_odometry_scans"), -1, 0.2);
    EXPECT_THAT(report.find("odometry.lag")->text, HasSubstr("before the odometry"));
}

TEST(OdometryOfALog, OdometryThatTurnsTooMuch)
{
    CheckDrive drive;
    drive.odometry = [](const Pose2& step) { return Pose2{step.x, step.y, 1.1 * step.yaw}; };
    const auto report = check_drive(drive);
    EXPECT_THAT(troubles(report), HasSubstr("WARN odometry.rotation_scale"));
    EXPECT_NEAR(figure(report, "odometry.rotation_scale", "scale"), 1.1, 0.01);
}

TEST(OdometryOfALog, OdometryInDegreesFails)
{
    CheckDrive drive;
    drive.odometry = [](const Pose2& step) { return Pose2{step.x, step.y, 2 * step.yaw}; };
    EXPECT_THAT(troubles(check_drive(drive)), HasSubstr("FAIL odometry.rotation_scale"));
}

TEST(OdometryOfALog, OdometryThatTravelsTooLittle)
{
    CheckDrive drive;
    drive.odometry = [](const Pose2& step) {
        return Pose2{0.9 * step.x, 0.9 * step.y, 1.02 * step.yaw};
    };
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "WARN odometry.travel_scale");
    EXPECT_NEAR(figure(report, "odometry.travel_scale", "scale"), 0.9, 0.01);
}

TEST(OdometryOfALog, OdometryThatDriftsSteadily)
{
    CheckDrive drive;
    drive.odometry = [](const Pose2& step) {
        return Pose2{step.x, step.y, step.yaw + 0.02 * step.x};
    };
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "WARN odometry.heading");
    // 0.02 rad/m is 11.5 deg each 10 m.
    EXPECT_NEAR(figure(report, "odometry.heading", "steady_deg_per_10_m"), 11.5, 1);
    EXPECT_NEAR(figure(report, "odometry.rotation_scale", "drift_deg_per_10_m"), 11.5, 1);
}

TEST(OdometryOfALog, OdometryThatNeverDrivesBackwards)
{
    CheckDrive drive;
    // Ahead for 30 scans, back for 15, again and again.
    drive.place = [](int scan)
    { return 15 * (scan / 45) + (scan % 45 < 30 ? scan % 45 : 60 - scan % 45); };
    EXPECT_EQ(troubles(check_drive(drive)), "") << "driving backwards is no fault";
    drive.odometry = [](const Pose2& step) {
        return Pose2{std::abs(step.x), step.y, 1.02 * step.yaw};
    };
    const auto report = check_drive(drive);
    EXPECT_THAT(troubles(report), HasSubstr("WARN odometry.reverse"));
    EXPECT_GT(figure(report, "odometry.reverse", "odometry_says_forward"), 80);
    EXPECT_EQ(figure(report, "odometry.reverse", "odometry_agrees"), 0);
}

TEST(OdometryOfALog, StandingIsNoFaultUnlessTheOdometryMoves)
{
    CheckDrive drive;
    drive.place = [](int scan) { return scan < 100 ? scan : std::max(100, scan - 50); };
    const auto clean = check_drive(drive);
    EXPECT_EQ(troubles(clean), "");
    EXPECT_EQ(figure(clean, "motion.rests", "periods"), 1);
    EXPECT_NEAR(figure(clean, "motion.rests", "longest_s"), 5, 0.5);

    drive.odometry = [](const Pose2& step) {
        return Pose2{step.x == 0 ? 0.01 : step.x, step.y, 1.02 * step.yaw};
    };
    EXPECT_THAT(troubles(check_drive(drive)), HasSubstr("WARN motion.rests"));
}

TEST(OdometryOfALog, OdometryThatIsTooGood)
{
    CheckDrive drive;
    drive.scans = 2 * house_lap_scans;  // two laps of 20 m
    drive.odometry = [](const Pose2& step) { return step; };
    EXPECT_EQ(troubles(check_drive(drive)), "WARN odometry.origin");
}

TEST(OdometryOfALog, MotionsOfARawlogCountAsOdometry)
{
    LogObjects objects;
    for (int k = 0; k < house_lap_scans; ++k)
    {
        mrpt::obs::CActionRobotMovement2D motion;
        const Pose2 step = between(pose_in_house(std::max(0, k - 1)), pose_in_house(k));
        motion.computeFromOdometry(mrpt::poses::CPose2D(step.x, step.y, 1.1 * step.yaw), {});
        auto actions = mrpt::obs::CActionCollection::Create();
        actions->insert(motion);
        auto frame = mrpt::obs::CSensoryFrame::Create();
        frame->insert(CObservation2DRangeScan::Create(scan_in_house(k)));
        objects.push_back(actions);
        objects.push_back(frame);
    }
    const auto report = check_objects(objects);
    EXPECT_NEAR(figure(report, "odometry.rotation_scale", "scale"), 1.1, 0.01);
}

TEST(OdometryOfALog, StoppingAndGoingIsNoFault)
{
    CheckDrive drive;
    drive.place = stop_and_go;
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "");
    EXPECT_NEAR(figure(report, "odometry.lag", "laser_after_odometry_scans"), 0, 0.11);
}
}  // namespace
}  // namespace rtob::test

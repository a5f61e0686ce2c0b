// SPDX-License-Identifier: BSD-3-Clause
// Whole logs with one fault each: it is found, and nothing else is; a clean log has none.
#include <check_drive.h>
#include <error_message.h>
#include <gmock/gmock.h>

namespace rtob::test
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;
using testing::HasSubstr;

constexpr double degree = 3.14159265358979323846 / 180;

/// Every tenth beam gets this value.
auto sentinel(float range_m, bool valid)
{
    return [=](CObservation2DRangeScan& scan, int)
    {
        for (std::size_t i = 0; i < scan.getScanSize(); i += 10)
        {
            scan.setScanRange(i, range_m);
            scan.setScanRangeValidity(i, valid);
        }
    };
}

TEST(CheckLog, ACleanLogHasNoTroubles)
{
    const auto report = check_drive({});
    EXPECT_EQ(troubles(report), "");
    EXPECT_EQ(report.worst(), Severity::Pass);
    for (const auto& finding : report.findings) EXPECT_EQ(finding.fix, "") << finding.id;
    EXPECT_NEAR(figure(report, "stamps.rate", "rate_hz"), 10, 0.01);
    EXPECT_EQ(figure(report, "laser.beams", "beams"), 361);
    EXPECT_NEAR(figure(report, "odometry.rotation_scale", "scale"), 1.02, 0.005);
    EXPECT_NEAR(figure(report, "odometry.travel_scale", "scale"), 1, 0.01);
    EXPECT_NEAR(figure(report, "odometry.lag", "laser_after_odometry_scans"), 0, 0.11);
    EXPECT_NEAR(figure(report, "odometry.mount", "turn_deg"), 0, 1);
}

TEST(CheckLog, ClockwiseBeamsThatTheLogFlags)
{
    CheckDrive drive;
    drive.spoil_scan = [](CObservation2DRangeScan& scan, int)
    {
        const auto seen = scan;
        for (std::size_t i = 0, n = seen.getScanSize(); i < n; ++i)
        {
            scan.setScanRange(i, seen.getScanRange(n - 1 - i));
            scan.setScanRangeValidity(i, seen.getScanRangeValidity(n - 1 - i));
        }
        scan.rightToLeft = false;
    };
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "");
    EXPECT_EQ(figure(report, "laser.direction", "clockwise"), 1);
}

TEST(CheckLog, ClockwiseBeamsThatTheLogDoesNotFlag)
{
    CheckDrive drive;
    drive.spoil_scan = [](CObservation2DRangeScan& scan, int) { scan.rightToLeft = false; };
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "FAIL odometry.sign");
    EXPECT_THAT(report.ini(), HasSubstr("upside_down = true\n"));
}

TEST(CheckLog, AMountThatIsTurned)
{
    CheckDrive drive;
    // The laser looks 90 degrees to the left, and the log calls that ahead.
    drive.spoil_scan = [](CObservation2DRangeScan& scan, int k)
    {
        Pose2 pose = pose_in_house(k);
        pose.yaw += 90 * degree;
        scan = scan_observation(house(), pose, 1000 + 0.1 * k, mrpt_laser());
    };
    const auto report = check_drive(drive);
    EXPECT_THAT(troubles(report), HasSubstr("FAIL odometry.mount"));
    EXPECT_NEAR(figure(report, "odometry.mount", "turn_deg"), 90, 2);
    EXPECT_THAT(report.ini(), HasSubstr("mount_yaw_deg = "));
}

TEST(CheckLog, ANoReturnThatWouldBecomeAWall)
{
    CheckDrive drive;
    drive.spoil_scan = sentinel(30, true);
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "FAIL ranges.no_return");
    EXPECT_NEAR(figure(report, "ranges.no_return", "usual_m"), 30, 0.005);
    EXPECT_EQ(figure(report, "ranges.no_return", "count"), house_lap_scans * 37);
    EXPECT_THAT(report.ini(), HasSubstr("[ScanFilter]\n"));
    EXPECT_THAT(report.ini(), HasSubstr("max_range_m = 29.10\n"));  // 3 % below
}

TEST(CheckLog, ANoReturnBeyondTheDefaultRange)
{
    CheckDrive drive;
    drive.spoil_scan = sentinel(81.83F, true);
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "WARN ranges.no_return");
    EXPECT_THAT(report.ini(), testing::Not(HasSubstr("max_range_m")));
}

TEST(CheckLog, ANoReturnThatTheLogFlags)
{
    CheckDrive drive;
    drive.spoil_scan = sentinel(30, false);
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "");
    EXPECT_EQ(figure(report, "ranges.no_return", "flagged_valid"), 0);
}

TEST(CheckLog, BeamsThatSeeTheVehicle)
{
    CheckDrive drive;
    drive.spoil_scan = [](CObservation2DRangeScan& scan, int k)
    {
        for (std::size_t i = 40; i <= 60; ++i)  // bearings -140 to -120 deg
        {
            scan.setScanRange(i, 0.35F + (k % 2 == 0 ? 0.01F : 0.0F));
            scan.setScanRangeValidity(i, true);
        }
    };
    const auto report = check_drive(drive);
    EXPECT_EQ(troubles(report), "FAIL sectors.body");
    EXPECT_EQ(figure(report, "sectors.body", "beams"), 21);
    EXPECT_THAT(report.ini(), HasSubstr("mask_deg = -141.2..-118.8\n"));
}

TEST(CheckLog, ASectorThatSeesNothing)
{
    CheckDrive drive;
    drive.spoil_scan = [](CObservation2DRangeScan& scan, int)
    {
        for (std::size_t i = 40; i < 60; ++i) scan.setScanRange(i, 0);
    };
    const auto report = check_drive(drive);
    EXPECT_THAT(troubles(report), HasSubstr("WARN sectors.blind"));
    EXPECT_THAT(report.find("sectors.blind")->text, HasSubstr("-140..-130, -130..-120 deg"));
}

TEST(CheckLog, KeyScansOnly)
{
    CheckDrive drive;
    drive.scans = 100;
    drive.place = [](int scan) { return 10 * scan; };
    const auto report = check_drive(drive);
    EXPECT_THAT(troubles(report), HasSubstr("WARN motion.spacing"));
    EXPECT_GT(figure(report, "motion.spacing", "spacing_m"), 0.5);
}

TEST(CheckLog, TwoLasersAreToldApart)
{
    auto objects = objects_of({});
    for (std::size_t i = 1; i < objects.size(); i += 4)
    {
        const auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(objects[i]);
        ASSERT_TRUE(scan);
        scan->sensorLabel = "REAR";
        sentinel(30, true)(*scan, 0);
    }
    const auto report = check_objects(objects);
    for (const auto& finding : report.findings)
    {
        EXPECT_THAT(finding.laser, testing::AnyOf("LASER", "REAR"));
        if (finding.id != "ranges.no_return") continue;
        EXPECT_EQ(finding.severity == Severity::Fail, finding.laser == "REAR");
    }
}

TEST(CheckLog, ACutLogIsCheckedUpToTheCut)
{
    const auto bytes = rawlog_bytes(objects_of({}));
    const TemporaryFile log(".rawlog", bytes.substr(0, bytes.size() / 2 + 100));
    const auto report = check_log(log.path());
    EXPECT_EQ(troubles(report), "FAIL log.damage");
    EXPECT_THAT(report.find("log.damage")->text, HasSubstr("truncated"));
    EXPECT_NEAR(figure(report, "laser.beams", "scans"), house_lap_scans / 2.0, 2);
}

TEST(CheckLog, ALogWithoutScansIsRefused)
{
    const TemporaryFile log(".log", "ODOM 1 2 0.5 0 0 0 10.5 host 0.1\n");
    EXPECT_THAT(
        error_message([&] { static_cast<void>(check_log(log.path())); }),
        HasSubstr(log.path() + ": the log holds no 2D laser scan (1 other entries)"));
}

TEST(CheckLog, EndsWhenAsked)
{
    const TemporaryFile log(".rawlog", rawlog_bytes(objects_of({})));
    double last = 0;
    const auto progress = [&](double share)
    {
        EXPECT_GE(share, last);
        last = share;
        return share < 0.6;
    };
    EXPECT_THAT(
        error_message([&] { static_cast<void>(check_log(log.path(), progress)); }),
        HasSubstr("stopped"));
    EXPECT_GE(last, 0.6);
    EXPECT_LT(last, 1.0);
}
}  // namespace
}  // namespace rtob::test

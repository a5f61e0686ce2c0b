// SPDX-License-Identifier: BSD-3-Clause
// Several lasers, and where they sit on the vehicle.
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <rtob/map/conversions.h>
#include <rtob/slam/slam.h>

#include <string>

#include "drive_log.h"
#include "near_pose.h"

using namespace rtob;
using mrpt::DEG2RAD;
using test::IsNearPose;

namespace
{
/// 241 beams around the laser's front, so that two back to back see some walls twice.
test::Laser wide_laser()
{
    return {241, -DEG2RAD(120.0), DEG2RAD(1.0), 6};
}

/// What a laser that sits there sees at step k of the circle.
mrpt::obs::CObservation2DRangeScan scan_from(
    const std::string& label, const Pose2& pose_vehicle_laser, int k, double delay_s = 0)
{
    auto scan = test::scan_observation(
        test::room_4x3(), compose(test::pose_on_circle(k), pose_vehicle_laser),
        test::drive_start_s + k * test::drive_step_s + delay_s, wide_laser());
    scan.sensorLabel = label;
    scan.sensorPose = mrpt::poses::CPose3D(to_cpose2d(pose_vehicle_laser));
    return scan;
}

const Pose2 pose_vehicle_front{0.2, 0.05, 0};
const Pose2 pose_vehicle_rear{-0.2, 0, DEG2RAD(180.0)};

/// Whether a drive with scans of a laser is tracked right, its origin the vehicle's.
void expect_tracked(
    const SlamOptions& options, const std::function<mrpt::obs::CObservation2DRangeScan(int)>& scan)
{
    Slam slam(options);
    for (int k = 0; k < 40; ++k)
    {
        const ScanReport* report = slam.observe(scan(k));
        ASSERT_NE(report, nullptr);
        EXPECT_EQ(report->state, TrackingState::Tracking) << k;
        EXPECT_THAT(report->pose_map_vehicle, IsNearPose(test::pose_on_circle_map(k), 0.02, 0.015))
            << k;
    }
}
}  // namespace

TEST(SlamSensors, SeveralLasersDrawOneMap)
{
    Slam slam;
    for (int k = 0; k < 40; ++k)
    {
        ASSERT_NE(slam.observe(scan_from("FRONT", pose_vehicle_front, k)), nullptr);
        ASSERT_NE(slam.observe(scan_from("REAR", pose_vehicle_rear, k, 0.001)), nullptr);
        // Until the vehicle has turned a little, most of what the rear laser sees is in no scan.
        const bool has_turned = k >= 10;
        EXPECT_TRUE(slam.state() == TrackingState::Tracking || !has_turned) << k;
        EXPECT_THAT(slam.pose(), IsNearPose(test::pose_on_circle_map(k), 0.02, 0.015)) << k;
    }
    EXPECT_GE(slam.map().scans().size(), 70U);
}

TEST(SlamSensors, LasersThatWereNotChosenArePassedOver)
{
    SlamOptions options;
    options.sensor.labels = "REAR";
    Slam slam(options);
    for (int k = 0; k < 20; ++k)
    {
        EXPECT_EQ(slam.observe(scan_from("FRONT", pose_vehicle_front, k)), nullptr);
        const ScanReport* report = slam.observe(scan_from("REAR", pose_vehicle_rear, k));
        ASSERT_NE(report, nullptr);
        EXPECT_THAT(report->pose_map_vehicle, IsNearPose(test::pose_on_circle_map(k), 0.02, 0.015))
            << k;
    }
    EXPECT_EQ(slam.map().scans().size(), 20U);
}

TEST(SlamSensors, TheLogsMountIsTaken)
{
    expect_tracked({}, [](int k) { return scan_from("FRONT", pose_vehicle_front, k); });
}

TEST(SlamSensors, AMountOfOurOwnReplacesAWrongOne)
{
    SlamOptions options;
    options.sensor.override_mount = true;
    options.sensor.mount_x_m = pose_vehicle_front.x;
    options.sensor.mount_y_m = pose_vehicle_front.y;
    expect_tracked(
        options,
        [](int k)
        {
            auto scan = scan_from("FRONT", pose_vehicle_front, k);
            scan.sensorPose = mrpt::poses::CPose3D(1, 1, 0, 0, 0, 0);
            return scan;
        });
}

TEST(SlamSensors, AMountOfOurOwnKeepsTheBeamsTurnOfTheLog)
{
    // A field of view from -90 to 150 degrees: MRPT writes it as +-120 degrees turned by 30.
    SlamOptions options;
    options.sensor.override_mount = true;
    options.sensor.mount_x_m = 0.2;
    expect_tracked(
        options,
        [](int k)
        {
            auto scan = scan_from("FRONT", {0.2, 0, DEG2RAD(30.0)}, k);
            scan.sensorPose = mrpt::poses::CPose3D(0, 0, 0, DEG2RAD(30.0), 0, 0);
            return scan;
        });
}

TEST(SlamSensors, AHangingLaserIsTurnedOver)
{
    SlamOptions options;
    options.sensor.override_mount = true;
    options.sensor.upside_down = true;
    expect_tracked(
        options,
        [](int k)
        {
            auto scan = scan_from("FRONT", {}, k);
            scan.rightToLeft = !scan.rightToLeft;  // as a laser that hangs would send it
            return scan;
        });
}

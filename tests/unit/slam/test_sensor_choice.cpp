// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <rtob/slam/sensor_choice.h>

#include <limits>
#include <stdexcept>
#include <string>

using mrpt::DEG2RAD;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose3D;
using rtob::SensorChoice;
using rtob::SensorOptions;

namespace
{
CObservation2DRangeScan scan_from(const std::string& label, const CPose3D& pose_vehicle_laser = {})
{
    CObservation2DRangeScan scan;
    scan.sensorLabel = label;
    scan.sensorPose = pose_vehicle_laser;
    return scan;
}

SensorOptions mounted(double x_m, double y_m, double yaw_deg, bool upside_down = false)
{
    SensorOptions options;
    options.override_mount = true;
    options.mount_x_m = x_m;
    options.mount_y_m = y_m;
    options.mount_yaw_deg = yaw_deg;
    options.upside_down = upside_down;
    return options;
}

/// Where the laser's point (1, 0.5) is on the vehicle.
void expect_point(const CPose3D& pose_vehicle_laser, double x, double y)
{
    mrpt::math::TPoint3D point;
    pose_vehicle_laser.composePoint(1, 0.5, 0, point.x, point.y, point.z);
    EXPECT_NEAR(point.x, x, 1e-9);
    EXPECT_NEAR(point.y, y, 1e-9);
}
}  // namespace

TEST(SensorChoice, TakesEveryLaserByDefault)
{
    EXPECT_TRUE(SensorChoice().uses(scan_from("")));
    EXPECT_TRUE(SensorChoice().uses(scan_from("FRONT")));
    SensorOptions blank;
    blank.labels = " , ";
    EXPECT_TRUE(SensorChoice(blank).uses(scan_from("FRONT")));
}

TEST(SensorChoice, TakesTheLasersThatAreNamed)
{
    SensorOptions options;
    options.labels = "FRONT , REAR";
    const SensorChoice choice(options);
    EXPECT_TRUE(choice.uses(scan_from("FRONT")));
    EXPECT_TRUE(choice.uses(scan_from("REAR")));
    for (const char* other : {"", "front", "FRONT2", "FRONT , REAR"})
        EXPECT_FALSE(choice.uses(scan_from(other))) << other;
}

TEST(SensorChoice, TakesTheLogsMount)
{
    const CPose3D of_the_log(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
    EXPECT_EQ(SensorChoice().mountOf(scan_from("", of_the_log)), of_the_log);
}

TEST(SensorChoice, AMountOfOurOwnReplacesTheLogsPlace)
{
    const SensorChoice choice(mounted(-0.04, 0.1, 0));
    expect_point(choice.mountOf(scan_from("", CPose3D(3, 4, 5, 0, 0, 0))), 0.96, 0.6);
}

TEST(SensorChoice, AMountOfOurOwnKeepsTheBeamsTurn)
{
    // A quarter turn of ours on a quarter turn of the log's: the laser looks back.
    const SensorChoice choice(mounted(0, 0, 90));
    expect_point(choice.mountOf(scan_from("", CPose3D(3, 4, 5, DEG2RAD(90.0), 0, 0))), -1, -0.5);
}

TEST(SensorChoice, AHangingLaserHasItsLeftOnTheRight)
{
    expect_point(SensorChoice(mounted(0, 0, 0, true)).mountOf(scan_from("")), 1, -0.5);
    // The beams' turn is to the laser's own left, which is the vehicle's right.
    expect_point(
        SensorChoice(mounted(0, 0, 0, true))
            .mountOf(scan_from("", CPose3D(0, 0, 0, DEG2RAD(90.0), 0, 0))),
        -0.5, -1);
}

TEST(SensorOptions, RefusesMountsThatAreNoNumbers)
{
    constexpr double inf = std::numeric_limits<double>::infinity();
    EXPECT_THROW(SensorChoice(mounted(inf, 0, 0)), std::invalid_argument);
    EXPECT_THROW(SensorChoice(mounted(0, -inf, 0)), std::invalid_argument);
    EXPECT_THROW(SensorChoice(mounted(0, 0, inf)), std::invalid_argument);
}

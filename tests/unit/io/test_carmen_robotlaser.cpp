// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "carmen_text.h"
#include "log_files.h"

namespace rtob::test
{
namespace
{
TEST(CarmenRobotLaser, UsesItsStartAngleAndStep)
{
    RobotLaserText text;
    text.start_angle = "-3.0";
    text.step = "0.01";
    text.count_and_ranges = "400 " + ranges_text(400);
    const auto log = read_text_log(text.line());
    ASSERT_EQ(log.error, "");
    const auto& scan = *log.scans().at(0);
    for (std::size_t i = 0; i < 400; ++i)
        EXPECT_NEAR(beam_angle_vehicle(scan, i), -3.0 + 0.01 * double(i), 1e-6) << "beam " << i;
}

TEST(CarmenRobotLaser, UsesItsMountAndItsTurn)
{
    RobotLaserText text;
    text.laser_pose = "1.145 2 0.1";
    text.vehicle_pose = "1 2 0";
    const auto log = read_text_log(text.line());
    const auto& scan = *log.scans().at(0);
    EXPECT_NEAR(scan.sensorPose.x(), 0.145, 1e-9);
    EXPECT_NEAR(beam_angle_vehicle(scan, 0), -1.0 + 0.1, 1e-6);
    EXPECT_NEAR(beam_angle_vehicle(scan, 2), 0.0 + 0.1, 1e-6);
}

TEST(CarmenRobotLaser, MayRunClockwise)
{
    RobotLaserText text;
    text.start_angle = "1.0";
    text.step = "-0.25";
    const auto log = read_text_log(text.line());
    const auto& scan = *log.scans().at(0);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(beam_angle_vehicle(scan, i), 1.0 - 0.25 * double(i), 1e-6);
}

TEST(CarmenRobotLaser, SkipsRemissions)
{
    RobotLaserText text;
    text.remissions = "3 900 901 902";
    const auto log = read_text_log(text.line());
    ASSERT_EQ(log.error, "");
    EXPECT_EQ(unix_100ns(*log.scans().at(0)), 105'000'000);
}

TEST(CarmenRobotLaser, MarksRangesThatAreNone)
{
    RobotLaserText text;
    text.count_and_ranges = "8 0 nan -1 6.0 7.5 5.99 inf 0.001";
    const auto log = read_text_log(text.line());
    ASSERT_EQ(log.error, "");
    const auto& scan = *log.scans().at(0);
    EXPECT_FLOAT_EQ(scan.maxRange, 6.0F);
    const bool expected[] = {false, false, false, false, false, true, false, true};
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_EQ(scan.getScanRangeValidity(i), expected[i]) << "beam " << i;
}
}  // namespace
}  // namespace rtob::test

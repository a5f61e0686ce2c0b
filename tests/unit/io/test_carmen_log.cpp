// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <clocale>
#include <cmath>

#include "carmen_text.h"
#include "log_files.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

constexpr double degree = 3.14159265358979323846 / 180;

struct Field
{
    std::size_t beams;
    double first_deg, step_deg;
};
class CarmenBeamAngles : public testing::TestWithParam<Field>
{
};

TEST_P(CarmenBeamAngles, AreRightForEveryBeam)
{
    const auto log = read_text_log(flaser_of(GetParam().beams));
    ASSERT_EQ(log.error, "");
    ASSERT_EQ(log.scans().size(), 1U);
    const auto& scan = *log.scans()[0];
    ASSERT_EQ(scan.getScanSize(), GetParam().beams);
    for (std::size_t i = 0; i < GetParam().beams; ++i)
    {
        const double expected_deg = GetParam().first_deg + GetParam().step_deg * double(i);
        // MRPT keeps angles as float: 2e-7 of a quarter turn
        EXPECT_NEAR(beam_angle_vehicle(scan, i) / degree, expected_deg, 5e-5) << "beam " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Scanners, CarmenBeamAngles,
    testing::Values(
        Field{180, -90, 1}, Field{181, -90, 1}, Field{360, -90, 0.5}, Field{361, -90, 0.5},
        Field{101, -50, 1}, Field{401, -50, 0.25}, Field{2, -90, 90}));

TEST(CarmenLog, GivesOdometryThenScanOfEachLaserLine)
{
    const auto log = read_text_log(flaser("2 1.5 2.5", "3 4 0.5", "1 2 0.25", "976052857.337530"));
    ASSERT_EQ(log.error, "");
    ASSERT_EQ(log.entries.size(), 2U);
    const auto& odometry = *log.odometry().at(0);
    const auto& scan = *log.scans().at(0);
    EXPECT_EQ(log.entries[0].observation, log.odometry()[0]);
    EXPECT_EQ(odometry.sensorLabel, "odometry");
    EXPECT_DOUBLE_EQ(odometry.odometry.x(), 1);
    EXPECT_DOUBLE_EQ(odometry.odometry.y(), 2);
    EXPECT_DOUBLE_EQ(odometry.odometry.phi(), 0.25);
    EXPECT_EQ(scan.sensorLabel, "laser_front");
    EXPECT_FLOAT_EQ(scan.getScanRange(0), 1.5F);
    EXPECT_FLOAT_EQ(scan.getScanRange(1), 2.5F);
    EXPECT_EQ(unix_100ns(scan), 9'760'528'573'375'300);
    EXPECT_EQ(unix_100ns(odometry), unix_100ns(scan));
}

TEST(CarmenLog, KeepsStampsToTheLastDigitThatMrptHolds)
{
    const auto stamp_of = [](const std::string& stamp)
    {
        const auto log = read_text_log(flaser("1 1", "1 0 0", "1 0 0", stamp));
        return log.error.empty() ? unix_100ns(*log.scans().at(0)) : -1;
    };
    EXPECT_EQ(stamp_of("1031745838.717000"), 10'317'458'387'170'000);
    EXPECT_EQ(stamp_of("1999999999.9999999"), 19'999'999'999'999'999);
    EXPECT_EQ(stamp_of("1999999999.99999994"), 19'999'999'999'999'999);
    EXPECT_EQ(stamp_of("1999999999.99999996"), 20'000'000'000'000'000);
    EXPECT_EQ(stamp_of("7"), 70'000'000);
    EXPECT_EQ(stamp_of("0.1"), 1'000'000);
    EXPECT_EQ(stamp_of("-20.1006"), -201'006'000);
    EXPECT_EQ(stamp_of("4.58664e-72"), 0);
    EXPECT_EQ(stamp_of("1.5e2"), 1'500'000'000);
}

TEST(CarmenLog, TakesTheMountFromTheParameterFirst)
{
    const auto log = read_text_log(
        "PARAM robot_frontlaser_offset -0.04 1.0 host 1.0\n" +
        flaser("1 1", "1.2 0 0", "1 0 0", "1.0"));
    EXPECT_NEAR(log.scans().at(0)->sensorPose.x(), -0.04, 1e-12);
}

TEST(CarmenLog, TakesTheMountFromTheLaserPoseWhereNoParameterTells)
{
    // The vehicle looks along y: 0.3 m ahead of it is +y in odom.
    const std::string text =
        flaser("1 1", "1 2.3 1.5707963267948966", "1 2 1.5707963267948966", "1") +
        flaser("1 1", "5 4.3 1.5707963267948966", "5 4 1.5707963267948966", "2");
    const auto log = read_text_log(text);
    ASSERT_EQ(log.scans().size(), 2U);
    for (const auto& scan : log.scans())
    {
        EXPECT_NEAR(scan->sensorPose.x(), 0.3, 1e-9);
        EXPECT_NEAR(scan->sensorPose.y(), 0, 1e-9);
        EXPECT_NEAR(scan->sensorPose.yaw(), 0, 1e-9);
    }
}

TEST(CarmenLog, DoesNotTakeACorrectedPoseForAMount)
{
    // The "laser" pose leaves the odometry as the vehicle drives: it is a corrected pose in map.
    const auto log = read_text_log(
        flaser("1 1", "0.1 0 0", "0 0 0", "1") + flaser("1 1", "2.3 0 0", "2 0 0", "2"));
    ASSERT_EQ(log.scans().size(), 2U);
    for (const auto& scan : log.scans()) EXPECT_EQ(scan->sensorPose.x(), 0);
}

TEST(CarmenLog, LetsTheRearLaserLookBack)
{
    const auto log = read_text_log(
        "PARAM robot_rearlaser_offset -0.2 1.0 host 1.0\n" +
        flaser("3 1 1 1", "1 0 0", "1 0 0", "1.0", "RLASER"));
    const auto& scan = *log.scans().at(0);
    EXPECT_EQ(scan.sensorLabel, "laser_rear");
    EXPECT_NEAR(scan.sensorPose.x(), -0.2, 1e-9);
    // 3 beams: -90, 0, +90 deg; the middle one looks straight back
    EXPECT_NEAR(std::cos(beam_angle_vehicle(scan, 1)), -1, 1e-9);
    EXPECT_NEAR(std::sin(beam_angle_vehicle(scan, 0)), 1, 1e-6);
}

TEST(CarmenLog, LeavesTheSentinelsOfFlaserToTheScanFilter)
{
    const auto log = read_text_log(flaser("3 81.83 0 51.11", "1 0 0", "1 0 0", "1"));
    const auto& scan = *log.scans().at(0);
    EXPECT_TRUE(scan.getScanRangeValidity(0));
    EXPECT_FALSE(scan.getScanRangeValidity(1));
    EXPECT_TRUE(scan.getScanRangeValidity(2));
    EXPECT_GT(scan.maxRange, 81.83F);
}

TEST(CarmenLog, GivesScansOfNoAndOneBeam)
{
    const auto none = read_text_log(flaser("0", "1 0 0", "1 0 0", "1"));
    ASSERT_EQ(none.scans().size(), 1U);
    EXPECT_EQ(none.scans()[0]->getScanSize(), 0U);
    const auto one = read_text_log(flaser("1 4", "1 0 0", "1 0 0", "1"));
    ASSERT_EQ(one.scans().size(), 1U);
    EXPECT_EQ(one.scans()[0]->getScanSize(), 1U);
    EXPECT_EQ(one.scans()[0]->sensorPose.yaw(), 0);
    EXPECT_EQ(one.scans()[0]->aperture, 0);
}

TEST(CarmenLog, OdomLinesCountOnlyWhereLaserLinesHaveNone)
{
    const std::string odom = "ODOM 7 8 0.5 0 0 0 1.5 host 0.1\n";
    const auto with = read_text_log(odom + flaser("1 1", "1 0 0", "1 0 0", "2") + odom);
    ASSERT_EQ(with.odometry().size(), 1U);
    EXPECT_EQ(with.odometry()[0]->odometry.x(), 1);

    const auto without = read_text_log(odom + flaser("1 1", "0 0 0", "0 0 0", "2") + odom);
    ASSERT_EQ(without.odometry().size(), 2U);
    EXPECT_EQ(without.odometry()[0]->odometry.x(), 7);
    EXPECT_EQ(without.scans().size(), 1U);
}

TEST(CarmenLog, PassesOverCommentsEmptyLinesAndOtherMessages)
{
    const auto log = read_text_log(
        "# a comment\n\n   \nNMEA-GGA 1 2 3\nSYNC tag\nTRUEPOS 1 2 3\r\n" +
        flaser("1 1", "1 0 0", "1 0 0", "2"));
    EXPECT_EQ(log.error, "");
    EXPECT_EQ(log.scans().size(), 1U);
}

TEST(CarmenLog, ReadsWindowsLineEndsAndAnOpenLastLine)
{
    std::string text = flaser("1 1", "1 0 0", "1 0 0", "2");
    text.pop_back();
    const auto log = read_text_log(text + "\r\n" + text);
    EXPECT_EQ(log.error, "");
    EXPECT_EQ(log.scans().size(), 2U);
}

TEST(CarmenLog, ALogWithoutScansIsNoError)
{
    const auto log = read_text_log("PARAM robot_length 0.5 1 host 1\n");
    EXPECT_EQ(log.error, "");
    EXPECT_TRUE(log.entries.empty());
}

TEST(CarmenLog, DoesNotDependOnTheLocale)
{
    // A locale with a decimal comma need not be installed; then this repeats the plain case.
    const char* const set = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
    const auto log = read_text_log(flaser("1 1.75", "1 0 0", "1 0 0", "2.5"));
    std::setlocale(LC_NUMERIC, "C");
    EXPECT_FLOAT_EQ(log.scans().at(0)->getScanRange(0), 1.75F) << (set ? set : "C");
    EXPECT_EQ(unix_100ns(*log.scans()[0]), 25'000'000);
}

TEST(CarmenLog, NamesLineAndExpectationOfAMalformedLine)
{
    const std::string good = flaser("1 1", "1 0 0", "1 0 0", "2");
    const auto error_of = [&](const std::string& bad)
    { return read_text_log(good + bad + good).error; };
    EXPECT_THAT(error_of("FLASER many 1\n"), HasSubstr("line 2"));
    EXPECT_THAT(error_of("FLASER many 1\n"), HasSubstr("num_readings"));
    EXPECT_THAT(error_of("FLASER 2 1 x 0 0 0 0 0 0 2 h 2\n"), HasSubstr("'x'"));
    EXPECT_THAT(error_of("FLASER 1 1 0 0 0 0 0 0\n"), HasSubstr("ipc_timestamp"));
    EXPECT_THAT(error_of("FLASER 1 1 0 0 0 0 nan 0 2 h 2\n"), HasSubstr("odom_y"));
    EXPECT_THAT(error_of("FLASER 1 1 0 0 0 0 0 0 2.5s h 2\n"), HasSubstr("time in seconds"));
    EXPECT_THAT(error_of("FLASER 1 1 0 0 0 0 0 0 9e99 h 2\n"), HasSubstr("time in seconds"));
    EXPECT_THAT(error_of("FLASER 4000000000 1\n"), HasSubstr("num_readings (0 to"));
    EXPECT_THAT(error_of("FLASER -1 1\n"), HasSubstr("num_readings"));
    EXPECT_THAT(error_of("ODOM 1 2\n"), HasSubstr("theta"));
    EXPECT_THAT(error_of("hello world\n"), HasSubstr("CARMEN message"));
    for (const char* bad : {"FLASER many 1\n", "hello world\n"})
        EXPECT_EQ(read_text_log(good + bad + good).scans().size(), 1U) << bad;
}

TEST(CarmenLog, TellsACutLastLineFromAMalformedOne)
{
    const std::string good = flaser("3 1 2 3", "1 0 0", "1 0 0", "12.345");
    const auto stamp_end = good.find("host");
    for (std::size_t cut = 1; cut < stamp_end; ++cut)
    {
        const auto log = read_text_log(good + good.substr(0, cut));
        EXPECT_THAT(log.error, HasSubstr("truncated")) << cut;
        EXPECT_THAT(log.error, HasSubstr("line 2")) << cut;
        EXPECT_EQ(log.scans().size(), 1U) << cut;
    }
}
}  // namespace
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/obs/CObservationIMU.h>
#include <rtob/io/carmen_writer.h>

#include <cmath>
#include <limits>

#include "drive_log.h"
#include "error_message.h"
#include "same_scan.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

constexpr double pi = 3.14159265358979323846;

/// Three beams at -90, 0 and +90 degrees: 1, 2 and 3 m; the laser at the origin.
CObservation2DRangeScan::Ptr three_beams(double stamp_s = 1000.5)
{
    auto scan = scan_of(3, 1, true, stamp_s);
    scan->aperture = static_cast<float>(pi);
    scan->maxRange = 20;
    scan->setScanRange(1, 2);
    scan->setScanRange(2, 3);
    return scan;
}

mrpt::obs::CObservationOdometry::Ptr odometry_at(double x, double y, double yaw, double stamp_s)
{
    auto odometry = mrpt::obs::CObservationOdometry::Create();
    odometry->timestamp = mrpt::Clock::fromDouble(stamp_s);
    odometry->sensorLabel = "wheels";
    odometry->odometry = {x, y, yaw};
    return odometry;
}

class CarmenWriterTest : public testing::Test
{
 protected:
    /// Writes the objects and reads the file back.
    ReadLog there_and_back(const LogObjects& objects)
    {
        file_ = folder_.file("log.clf");
        const std::string rawlog = folder_.write("log.rawlog", rawlog_bytes(objects));
        CarmenWriter writer(file_, survey_log(*open_log(rawlog)));
        const auto log = open_log(rawlog);
        while (const auto entry = log->next()) writer.write(*entry);
        writer.commit();
        losses_ = writer.losses();
        return read_log(file_);
    }
    CObservation2DRangeScan::Ptr scan_back(const CObservation2DRangeScan::Ptr& scan)
    {
        const auto log = there_and_back({scan});
        EXPECT_EQ(log.error, "");
        return log.scans().at(0);
    }
    std::string refusal(const LogObjects& objects)
    {
        return error_message([&] { there_and_back(objects); });
    }
    /// The lines without the comments.
    std::string lines() const
    {
        std::istringstream text(file_content(file_));
        std::string kept;
        for (std::string line; std::getline(text, line);)
            if (line.front() != '#') kept += line + "\n";
        return kept;
    }

    TemporaryFolder folder_;
    std::string file_;
    LogLosses losses_;
};

TEST_F(CarmenWriterTest, WritesTheLinesThatOtherProgramsRead)
{
    auto scan = three_beams();
    scan->aperture = 2;  // a number with few digits
    scan->sensorPose = mrpt::poses::CPose3D(0.25, 0, 0, 0, 0, 0);
    there_and_back({odometry_at(1, 2, 0, 1000), scan});
    EXPECT_EQ(
        lines(),
        "ODOM 1 2 0 0 0 0 1000.000000 rtob 0.000000\n"
        "ROBOTLASER1 0 -1 2 1 20 0.01 0 3 1 2 3 0 1.25 2 0 1 2 0 0 0 0 0 0 1000.500000 rtob "
        "0.500000\n");
    EXPECT_THAT(losses_, IsEmpty());
}

TEST_F(CarmenWriterTest, KeepsMountOdometryAndStamp)
{
    auto scan = three_beams();
    scan->sensorPose = mrpt::poses::CPose3D(-0.1, 0.05, 0, 0.3, 0, 0);
    scan->timestamp = mrpt::Clock::fromDouble(1000.5) + mrpt::Clock::duration(1);
    const auto log = there_and_back({odometry_at(5, -7, 2.5, 1000.4), scan});
    EXPECT_EQ(difference(*log.scans().at(0), *scan), "");
    const auto& odometry = log.odometry().at(0)->odometry;
    EXPECT_EQ(odometry.x(), 5);
    EXPECT_EQ(odometry.y(), -7);
    EXPECT_EQ(odometry.phi(), 2.5);
}

TEST_F(CarmenWriterTest, KeepsTheMountWithoutOdometry)
{
    auto scan = three_beams();
    scan->sensorPose = mrpt::poses::CPose3D(-0.1, 0.05, 0, 0.3, 0, 0);
    const auto log = there_and_back({scan});
    EXPECT_EQ(difference(*log.scans().at(0), *scan), "");
    EXPECT_TRUE(log.odometry().empty());
}

TEST_F(CarmenWriterTest, TurnsClockwiseScansRound)
{
    auto scan = three_beams();
    scan->rightToLeft = false;  // 1, 2, 3 m at +90, 0, -90 degrees
    const auto back = scan_back(scan);
    EXPECT_TRUE(back->rightToLeft);
    for (std::size_t i = 0; i < 3; ++i)
    {
        EXPECT_EQ(back->getScanRange(i), scan->getScanRange(2 - i));
        EXPECT_NEAR(beam_angle_vehicle(*back, i), beam_angle_vehicle(*scan, 2 - i), 1e-6);
    }
    EXPECT_THAT(losses_, ElementsAre(Pair(HasSubstr("clockwise"), 1)));
}

/// Hanging, the beam at -90 degrees of the laser looks to the vehicle's left.
TEST_F(CarmenWriterTest, TurnsHangingLasersRound)
{
    auto scan = three_beams();
    scan->sensorPose = mrpt::poses::CPose3D(0, 0, 0, 0, 0, pi);
    const auto back = scan_back(scan);
    EXPECT_EQ(back->getScanRange(0), 3);  // the right, from above
    EXPECT_EQ(back->getScanRange(2), 1);
    EXPECT_NEAR(beam_angle_vehicle(*back, 0), -pi / 2, 1e-6);
    EXPECT_NEAR(back->sensorPose.roll(), 0, 1e-12);

    scan->rightToLeft = false;  // twice turned is not turned
    const auto same = scan_back(scan);
    EXPECT_EQ(same->getScanRange(0), 1);
}

TEST_F(CarmenWriterTest, SaysNoReturnForInvalidBeams)
{
    auto scan = scan_of(5, 2, true, 1000);
    scan->maxRange = 20;
    scan->setScanRangeValidity(0, false);  // its 2 m would be taken for a wall
    scan->setScanRange(1, 20);
    scan->setScanRangeValidity(1, false);
    scan->setScanRange(2, std::nanf(""));
    scan->setScanRangeValidity(2, false);
    scan->setScanRange(3, 0);
    const auto back = scan_back(scan);
    const float ranges[] = {0, 20, 0, 0, 2};
    for (std::size_t i = 0; i < 5; ++i)
    {
        EXPECT_EQ(back->getScanRange(i), ranges[i]) << i;
        EXPECT_EQ(back->getScanRangeValidity(i), i == 4) << i;
    }
    EXPECT_THAT(
        losses_, ElementsAre(
                     Pair(HasSubstr("ranges of invalid beams"), 1),
                     Pair(HasSubstr("valid beams whose range is none"), 1)));
}

TEST_F(CarmenWriterTest, KeepsValidBeamsBeyondTheMaximumRange)
{
    auto scan = three_beams();
    scan->maxRange = 2.5F;
    const auto back = scan_back(scan);
    EXPECT_TRUE(back->getScanRangeValidity(2));
    EXPECT_EQ(difference(*back, *scan), "");
}

TEST_F(CarmenWriterTest, KeepsIntensity)
{
    auto scan = three_beams();
    scan->setScanHasIntensity(true);
    for (int i = 0; i < 3; ++i) scan->setScanIntensity(std::size_t(i), 900 + i);
    const auto back = scan_back(scan);
    ASSERT_TRUE(back->hasIntensity());
    EXPECT_EQ(back->getScanIntensity(0), 900);
    EXPECT_EQ(back->getScanIntensity(2), 902);
}

/// Every number of a few hundred thousand floats reads back as itself.
TEST_F(CarmenWriterTest, ChangesNoBitOfARange)
{
    constexpr std::size_t beams = 50'000;
    auto scan = scan_of(beams, 0, true, 1000);
    scan->maxRange = 1000;
    float range_m = 0.001F;
    for (std::size_t i = 0; i < beams; ++i, range_m *= 1.0002F) scan->setScanRange(i, range_m);
    EXPECT_GT(range_m, 20);
    const auto back = scan_back(scan);
    for (std::size_t i = 0; i < beams; ++i)
        ASSERT_EQ(back->getScanRange(i), scan->getScanRange(i)) << i;
}

TEST_F(CarmenWriterTest, NamesTwoLasersAndRefusesThree)
{
    const auto laser = [](const std::string& label)
    {
        auto scan = three_beams();
        scan->sensorLabel = label;
        return scan;
    };
    const auto log = there_and_back({laser("low"), laser("high"), laser("low")});
    ASSERT_EQ(log.scans().size(), 3U);
    EXPECT_EQ(log.scans()[1]->sensorLabel, "laser_rear");
    EXPECT_THAT(
        file_content(file_),
        testing::AllOf(HasSubstr("# ROBOTLASER1: 'low'\n"), HasSubstr("# ROBOTLASER2: 'high'\n")));
    EXPECT_THAT(
        refusal({laser("a"), laser("b"), laser("c")}),
        testing::AllOf(HasSubstr("3 lasers ('a', 'b', 'c')"), HasSubstr("--lasers")));
}

TEST_F(CarmenWriterTest, RefusesLasersThatItCannotPlace)
{
    auto tilted = three_beams(), moved = three_beams();
    tilted->sensorPose = mrpt::poses::CPose3D(0, 0, 0, 0, 0.1745, 0);
    moved->sensorPose = mrpt::poses::CPose3D(0.01, 0, 0, 0, 0, 0);
    EXPECT_THAT(refusal({tilted}), HasSubstr("tilted by 10 degrees"));
    EXPECT_THAT(refusal({three_beams(), moved}), HasSubstr("moves on the vehicle"));
    EXPECT_THAT(refusal({odometry_at(0, 0, 0, 1)}), HasSubstr("no 2D laser scan"));
    EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(CarmenWriterTest, CountsWhatCarmenHasNoPlaceFor)
{
    auto scan = three_beams();
    scan->sensorPose = mrpt::poses::CPose3D(0, 0, 0.4, 0, 0.01, 0);
    auto unstamped = mrpt::obs::CObservation2DRangeScan::Create(*scan);
    unstamped->timestamp = INVALID_TIMESTAMP;
    auto wheels = odometry_at(1, 0, 0, 1001);
    wheels->hasEncodersInfo = wheels->hasVelocities = true;
    wheels->velocityLocal = {0.5, 0.1, 0.2};
    const auto log =
        there_and_back({scan, unstamped, wheels, mrpt::obs::CObservationIMU::Create()});
    EXPECT_THAT(
        losses_,
        ElementsAre(
            Pair(HasSubstr("without a stamp"), 1), Pair(HasSubstr("height"), 1),
            Pair(HasSubstr("CObservationIMU"), 1), Pair(HasSubstr("before the first odometry"), 2),
            Pair(HasSubstr("sideways"), 1), Pair(HasSubstr("tilt"), 1),
            Pair(HasSubstr("encoder"), 1)));
    EXPECT_THAT(lines(), HasSubstr("ODOM 1 0 0 0.5 0.2 0 1001"));
    EXPECT_EQ(log.scans().at(1)->timestamp, scan->timestamp);
}
}  // namespace
}  // namespace rtob::test

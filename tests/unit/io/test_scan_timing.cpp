// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>
#include <rtob/io/scan_timing.h>

#include <limits>

namespace rtob
{
namespace
{
mrpt::obs::CObservation2DRangeScan scan()
{
    mrpt::obs::CObservation2DRangeScan scan;
    scan.timestamp = mrpt::Clock::fromDouble(1234.5);
    scan.sensorLabel = "LASER";
    return scan;
}

TEST(ScanTiming, SurvivesALog)
{
    mrpt::io::CMemoryStream file;
    auto archive = mrpt::serialization::archiveFrom(file);
    archive << *timing_record(scan(), {0.0987}) << *dropped_record(scan());
    file.Seek(0);
    const auto timing = archive.ReadObject<mrpt::obs::CObservation>();
    EXPECT_EQ(scan().timestamp, timing->timestamp);
    ASSERT_TRUE(read_timing_record(*timing));
    EXPECT_EQ(0.0987, read_timing_record(*timing)->sweep_s);
    EXPECT_FALSE(is_dropped_record(*timing));
    const auto dropped = archive.ReadObject<mrpt::obs::CObservation>();
    EXPECT_TRUE(is_dropped_record(*dropped));
    EXPECT_FALSE(read_timing_record(*dropped));
}

TEST(ScanTiming, IsInNoOtherObservation)
{
    mrpt::obs::CObservationRawDAQ other;
    other.sensorLabel = "DAQ";
    other.AIN_double = {1};
    EXPECT_FALSE(read_timing_record(other));
    EXPECT_FALSE(is_dropped_record(other));
    mrpt::obs::CObservationOdometry odometry;
    odometry.sensorLabel = "rtob.dropped";
    EXPECT_FALSE(is_dropped_record(odometry));
}

TEST(ScanTiming, RefusesWhatIsNoTime)
{
    for (const double bad :
         {-0.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_FALSE(read_timing_record(*timing_record(scan(), {bad}))) << bad;
}
}  // namespace
}  // namespace rtob

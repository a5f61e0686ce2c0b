// SPDX-License-Identifier: BSD-3-Clause
// The readers on real logs, found through the environment variable RTOB_DATASETS.
#include <gmock/gmock.h>

#include <boost/iostreams/device/file.hpp>
#include <cmath>
#include <cstdlib>
#include <istream>
#include <set>

#include "log_files.h"

namespace rtob::test
{
namespace
{
class RealLogs : public testing::Test
{
 protected:
    void SetUp() override
    {
        const char* folder = std::getenv("RTOB_DATASETS");
        if (folder == nullptr) GTEST_SKIP() << "RTOB_DATASETS is not set";
        folder_ = std::string(folder) + "/";
    }

    ReadLog read(const std::string& file) const { return read_log(folder_ + file); }

    /// The stamps in a file of relations, in microseconds.
    std::set<std::int64_t> relation_stamps_us(const std::string& file) const
    {
        boost::iostreams::filtering_istreambuf unpacked;
        unpacked.push(boost::iostreams::gzip_decompressor());
        unpacked.push(boost::iostreams::file_source(folder_ + file, std::ios::binary));
        std::istream in(&unpacked);
        std::set<std::int64_t> stamps_us;
        double t1, t2, ignored;
        while (in >> t1 >> t2)
        {
            stamps_us.insert({std::llround(t1 * 1e6), std::llround(t2 * 1e6)});
            for (int i = 0; i < 6; ++i) in >> ignored;
        }
        return stamps_us;
    }

    std::string folder_;
};

std::int64_t unix_us(const mrpt::obs::CObservation& observation)
{
    return std::llround(mrpt::Clock::toDouble(observation.timestamp) * 1e6);
}

struct Expected
{
    std::size_t scans, beams;
    double first_deg, last_deg, mount_x_m;
};

void expect_as_published(
    const ReadLog& log, const std::set<std::int64_t>& relations, const Expected& expected)
{
    constexpr double degree = 3.14159265358979323846 / 180;
    const auto scans = log.scans();
    EXPECT_EQ(log.error, "");
    ASSERT_EQ(scans.size(), expected.scans);
    EXPECT_EQ(log.odometry().size(), expected.scans);
    EXPECT_EQ(log.entries.size(), 2 * expected.scans);
    std::set<std::int64_t> stamps_us;
    for (const auto& scan : scans)
    {
        ASSERT_EQ(scan->getScanSize(), expected.beams);
        ASSERT_NEAR(scan->sensorPose.x(), expected.mount_x_m, 1e-9);
        const double middle = scan->sensorPose.yaw();
        ASSERT_NEAR((middle + scan->getScanAngle(0)) / degree, expected.first_deg, 1e-4);
        ASSERT_NEAR(
            (middle + scan->getScanAngle(expected.beams - 1)) / degree, expected.last_deg, 1e-4);
        stamps_us.insert(unix_us(*scan));
    }
    EXPECT_GT(relations.size(), 500U);
    for (const auto stamp_us : relations) EXPECT_EQ(stamps_us.count(stamp_us), 1U) << stamp_us;
}

TEST_F(RealLogs, IntelIsReadAsPublished)
{
    const auto log = read("intel/intel.clf.bz2");
    expect_as_published(
        log, relation_stamps_us("intel/intel.relations.gz"), {13631, 180, -90, 89, 0});
    const auto scans = log.scans();
    std::size_t steps_back = 0;
    for (std::size_t i = 1; i < scans.size(); ++i)
        steps_back += scans[i]->timestamp < scans[i - 1]->timestamp;
    EXPECT_EQ(steps_back, 631U);  // file order is kept
}

TEST_F(RealLogs, Fr079IsReadAsPublished)
{
    expect_as_published(
        read("fr079/fr079.clf.bz2"), relation_stamps_us("fr079/fr079.relations.gz"),
        {4934, 360, -90, 89.5, -0.04});
}

TEST_F(RealLogs, KillianIsReadAsPublished)
{
    expect_as_published(
        read("mit-killian/mit-killian.reconstructed.clf.gz"),
        relation_stamps_us("mit-killian/mit-killian.relations.gz"), {17480, 180, -90, 89, 0});
}

TEST_F(RealLogs, RobotLaserLogsKeepMountFieldAndOdometry)
{
    const auto urg = read("mines_urg/exp1.norm.clf.gz");
    EXPECT_EQ(urg.error, "");
    ASSERT_EQ(urg.scans().size(), 756U);
    EXPECT_EQ(urg.odometry().size(), 756U);
    const auto& scan = *urg.scans().back();
    EXPECT_EQ(scan.getScanSize(), 682U);
    EXPECT_NEAR(scan.sensorPose.x(), 0.145, 1e-6);
    EXPECT_NEAR(scan.sensorPose.yaw() + scan.getScanAngle(0), -2.091324, 1e-5);

    const auto rplidar = read("slambot_rplidar/data_24JUL14_14m.norm.clf.gz");
    ASSERT_EQ(rplidar.scans().size(), 237U);
    const auto& full_turn = *rplidar.scans().back();
    EXPECT_NEAR(full_turn.sensorPose.yaw() + full_turn.getScanAngle(0), -3.141593, 1e-5);
}

TEST_F(RealLogs, AHandHeldLogHasNoOdometry)
{
    const auto log = read("ccny_handheld/demo.norm.clf.gz");
    EXPECT_EQ(log.error, "");
    EXPECT_EQ(log.scans().size(), 360U);
    EXPECT_TRUE(log.odometry().empty());
}

TEST_F(RealLogs, AMuseumLogWithOddStampsIsRead)
{
    const auto log = read("fhw_museum/fhw-corrected.log.gz");
    EXPECT_EQ(log.error, "");
    EXPECT_EQ(log.scans().size(), 488U);
    EXPECT_EQ(log.odometry().size(), 488U);
}
}  // namespace
}  // namespace rtob::test

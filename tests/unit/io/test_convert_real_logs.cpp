// SPDX-License-Identifier: BSD-3-Clause
// Round trips of real logs, found through the environment variable RTOB_DATASETS.
#include <gmock/gmock.h>
#include <rtob/io/carmen_writer.h>
#include <rtob/io/rawlog_writer.h>

#include <cstdlib>

#include "same_scan.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
void copy_log(const std::string& from, LogWriter& to)
{
    const auto log = open_log(from);
    while (const auto entry = log->next()) to.write(*entry);
    to.commit();
}

/// Entry for entry, without holding a log in memory.
void expect_same_log(const std::string& a, const std::string& b)
{
    const auto log_a = open_log(a), log_b = open_log(b);
    for (std::size_t entry = 0;; ++entry)
    {
        const auto in_a = log_a->next(), in_b = log_b->next();
        ASSERT_EQ(in_a.has_value(), in_b.has_value()) << entry;
        if (!in_a) break;
        using namespace mrpt::obs;
        const auto* scan_a = dynamic_cast<CObservation2DRangeScan*>(in_a->observation.get());
        const auto* scan_b = dynamic_cast<CObservation2DRangeScan*>(in_b->observation.get());
        ASSERT_EQ(scan_a == nullptr, scan_b == nullptr) << entry;
        if (scan_a != nullptr)
        {
            ASSERT_EQ(difference(*scan_a, *scan_b), "") << "entry " << entry;
            ASSERT_EQ(scan_a->maxRange, scan_b->maxRange);
            continue;
        }
        const auto& odometry_a = dynamic_cast<CObservationOdometry&>(*in_a->observation);
        const auto& odometry_b = dynamic_cast<CObservationOdometry&>(*in_b->observation);
        ASSERT_EQ(odometry_a.timestamp, odometry_b.timestamp);
        ASSERT_EQ(odometry_a.odometry.x(), odometry_b.odometry.x());
        ASSERT_EQ(odometry_a.odometry.y(), odometry_b.odometry.y());
        ASSERT_EQ(odometry_a.odometry.phi(), odometry_b.odometry.phi());
    }
}

class ConvertRealLogs : public testing::TestWithParam<const char*>
{
};

/// CARMEN -> rawlog -> CARMEN -> read. Ranges, validity, stamps and odometry stay bit by bit (a
/// range is a float in MRPT: 4e-6 m of 50 m), angles within MRPT's float aperture.
TEST_P(ConvertRealLogs, ComeBackUnchanged)
{
    const char* const datasets = std::getenv("RTOB_DATASETS");
    if (datasets == nullptr) GTEST_SKIP() << "RTOB_DATASETS is not set";
    const std::string original = std::string(datasets) + "/" + GetParam();
    const TemporaryFolder folder;
    const std::string rawlog = folder.file("a.rawlog"), carmen = folder.file("a.clf");
    RawlogWriter to_rawlog(rawlog);
    copy_log(original, to_rawlog);
    expect_same_log(original, rawlog);
    CarmenWriter to_carmen(carmen, survey_log(*open_log(rawlog)));
    copy_log(rawlog, to_carmen);
    EXPECT_THAT(to_carmen.losses(), testing::IsEmpty());
    expect_same_log(original, carmen);
}

INSTANTIATE_TEST_SUITE_P(
    Carmen, ConvertRealLogs,
    testing::Values(
        "fr079/fr079.clf.bz2", "mines_urg/exp3.norm.clf.gz", "fhw_museum/fhw-corrected.log.gz",
        "ccny_handheld/demo.norm.clf.gz", "slambot_rplidar/data_24JUL14_14m.norm.clf.gz"));
}  // namespace
}  // namespace rtob::test

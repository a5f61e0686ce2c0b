// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/io/tum.h>

#include <limits>

#include "run/scan_files.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;
using testing::StartsWith;

ScanReport report_at(double stamp_s)
{
    ScanReport report;
    report.stamp_s = stamp_s;
    report.map_time_s = 2.5;
    report.pose_map_vehicle = {1, -2, 0.5};
    report.state = TrackingState::Degraded;
    report.verdict = FitVerdict::Weak;
    report.beams.used = 90;
    report.pairs = 30;
    report.paired_share = 1.0 / 3;
    report.covariance(0, 2) = 0.25;
    report.covariance_in_map(1, 1) = 0.5;
    report.weak = {0.125, -0.75};
    report.times.draw_s = 0.001;
    report.times.align_s = 0.002;
    return report;
}

std::vector<std::string> lines_of(const std::string& file)
{
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

TEST(ScanFiles, HaveALineForEveryScanInItsOrder)
{
    const TemporaryFolder folder;
    ScanFiles files(OutputFolder(folder.path(), false));
    files.add(report_at(1234567890.123456));
    files.add(report_at(1234567889.5));  // stamps may step back
    files.commit();

    const auto poses = lines_of(folder.file("poses.csv"));
    ASSERT_EQ(poses.size(), 3u);
    EXPECT_THAT(poses[0], StartsWith("stamp_s,map_time_s,x_m,y_m,yaw_rad,state,"));
    EXPECT_EQ(
        poses[1],
        "1234567890.123456,2.500000,1.000000,-2.000000,0.500000000,DEGRADED,weak_match,"
        "0,0,0.25,0,0,0,0,0.3333,30,90,0,0,0,"
        "0,0,0,0.5,0,0,0.12500,-0.7500");
    const auto times = lines_of(folder.file("timing.csv"));
    ASSERT_EQ(times.size(), 3u);
    EXPECT_EQ(
        times[2], "1234567889.500000,3.0000,0.0000,0.0000,1.0000,2.0000,0.0000,0.0000,0.0000");
    const auto trajectory = read_tum(folder.file("trajectory.tum"));
    ASSERT_EQ(trajectory.size(), 2u);
    EXPECT_EQ(trajectory[1].time_s, 1234567889.5);
    EXPECT_NEAR(trajectory[1].pose.yaw, 0.5, 1e-8);
}

TEST(ScanFiles, EveryLineHasTheColumnsOfItsTitle)
{
    const TemporaryFolder folder;
    ScanFiles files(OutputFolder(folder.path(), false));
    files.add(report_at(1));
    files.commit();
    for (const char* name : {"poses.csv", "timing.csv"})
    {
        const auto lines = lines_of(folder.file(name));
        EXPECT_EQ(
            std::count(lines[0].begin(), lines[0].end(), ','),
            std::count(lines[1].begin(), lines[1].end(), ','))
            << name;
    }
}

TEST(ScanFiles, AStampThatIsNoNumberLeavesReadableFiles)
{
    const TemporaryFolder folder;
    ScanFiles files(OutputFolder(folder.path(), false));
    files.add(report_at(std::numeric_limits<double>::quiet_NaN()));
    files.commit();
    ASSERT_EQ(read_tum(folder.file("trajectory.tum")).size(), 1u);
}

TEST(ScanFiles, AreNotThereBeforeTheyAreWhole)
{
    const TemporaryFolder folder;
    {
        ScanFiles files(OutputFolder(folder.path(), false));
        files.add(report_at(1));
        EXPECT_FALSE(std::filesystem::exists(folder.file("poses.csv")));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "given up: nothing is left";
}
}  // namespace
}  // namespace rtob::test

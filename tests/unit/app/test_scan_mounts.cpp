// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "run/scan_mounts.h"

namespace rtob
{
namespace
{
ScanReport report_at(double map_time_s, bool inserted)
{
    ScanReport report;
    report.map_time_s = map_time_s;
    report.inserted = inserted;
    report.beams.used = 100;
    report.verdict = FitVerdict::Good;
    report.pairs = 90;
    return report;
}

ScanTable scans_at(const std::vector<double>& times_s)
{
    ScanTable scans;
    for (const double time_s : times_s) scans.append(time_s, {}, 1);
    return scans;
}

TEST(ScanMounts, GivesEachScanOfTheMapItsMount)
{
    ScanMounts mounts;
    mounts.add(report_at(0, true), {0.1, 0, 0});
    mounts.add(report_at(1, false), {0.2, 0, 0});  // not in the map
    mounts.add(report_at(2, true), {0.3, 0, 0});
    mounts.add(report_at(3, true), {0.4, 0, 0});
    const auto all = mounts.of(scans_at({0, 2, 3}));
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[1].x, 0.3);
    const auto thinned = mounts.of(scans_at({0, 3}));
    EXPECT_EQ(thinned[1].x, 0.4);
}

TEST(ScanMounts, TakesScansOfAnEarlierRunForTheFirstLasers)
{
    ScanMounts mounts;
    mounts.add(report_at(10, false), {0.1, 0, 0});
    mounts.add(report_at(11, true), {0.2, 0, 0});
    const auto all = mounts.of(scans_at({3, 4, 11}));
    EXPECT_EQ(all[0].x, 0.1);
    EXPECT_EQ(all[1].x, 0.1);
    EXPECT_EQ(all[2].x, 0.2);
}

TEST(ScanMounts, ForgetsAMapThatBeganAnew)
{
    ScanMounts mounts;
    mounts.add(report_at(0, true), {0.1, 0, 0});
    mounts.add(report_at(1, true), {0.2, 0, 0});
    ScanReport start = report_at(0, true);
    start.pairs = 0;  // nothing was there to be paired with
    mounts.add(start, {0.3, 0, 0});
    const auto all = mounts.of(scans_at({0}));
    EXPECT_EQ(all[0].x, 0.3);
}
}  // namespace
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/random.h>
#include <rtob/core/scan_table.h>

#include <limits>
#include <stdexcept>
#include <vector>

using rtob::ScanTable;

namespace
{
/// 3000 scans: a third at the time of the one before, the rest 1 to 3 steps of 0.125 s later (exact
/// in binary); 0, 1 or up to 400 points each.
ScanTable irregular_table(std::uint64_t seed)
{
    rtob::Random random(seed);
    ScanTable table;
    double time_s = 5;
    for (int i = 0; i < 3000; ++i)
    {
        const auto kind = random.below(4);
        const auto points = kind < 2 ? kind : random.below(400);
        table.append(time_s, {double(i), -double(i), 0.5}, static_cast<std::uint32_t>(points));
        if (random.below(3) != 0) time_s += 0.125 * static_cast<double>(1 + random.below(3));
    }
    return table;
}

std::size_t linear_back_to(const ScanTable& table, double time_s, std::size_t from)
{
    while (from > 0 && table.time(from - 1) >= time_s) --from;
    return from;
}

std::size_t linear_forward_to(const ScanTable& table, double time_s, std::size_t from)
{
    while (from < table.size() && table.time(from) <= time_s) ++from;
    return from;
}
}  // namespace

TEST(ScanTable, IsEmptyAtFirst)
{
    const ScanTable table;
    EXPECT_TRUE(table.empty());
    EXPECT_EQ(table.pointCount(), 0u);
    EXPECT_EQ(table.firstScanSince(0), 0u);
    EXPECT_EQ(table.backTo(0, 0), 0u);
    EXPECT_EQ(table.forwardTo(0, 0), 0u);
    EXPECT_EQ(table.densestSecond(), 0u);
}

TEST(ScanTable, FindsTheScanOfEachPoint)
{
    const ScanTable table = irregular_table(1);
    std::uint64_t points = 0;
    for (std::size_t scan = 0; scan < table.size(); ++scan)
        for (auto i = table.firstPoint(scan); i < table.firstPoint(scan + 1); ++i, ++points)
            ASSERT_EQ(table.scanOf(i), scan) << "point " << i;
    EXPECT_EQ(points, table.pointCount());
}

TEST(ScanTable, FindsTheScanAmongScansOfOnePointAndNone)
{
    ScanTable table;
    for (int i = 0; i < 300; ++i) table.append(i, {}, i % 3 == 0 ? 1 : 0);
    for (std::uint64_t point = 0; point < table.pointCount(); ++point)
        EXPECT_EQ(table.scanOf(point), 3 * point);
}

TEST(ScanTable, GallopingEqualsLinearSearch)
{
    const ScanTable table = irregular_table(2);
    rtob::Random random(3);
    const double end_s = table.time(table.size() - 1);
    for (int i = 0; i < 3000; ++i)
    {
        // On the grid of the times, so that equal times are met; also before and after all.
        const double time_s =
            0.125 *
            static_cast<double>(random.below(static_cast<std::uint64_t>((end_s + 10) / 0.125)));
        const std::size_t from = random.below(table.size() + 1);
        ASSERT_EQ(table.backTo(time_s, from), linear_back_to(table, time_s, from)) << time_s;
        ASSERT_EQ(table.forwardTo(time_s, from), linear_forward_to(table, time_s, from)) << time_s;
        ASSERT_EQ(table.firstScanSince(time_s), linear_back_to(table, time_s, table.size()));
    }
}

TEST(ScanTable, DensestSecondBoundsEachSecond)
{
    ScanTable table;
    for (const double time_s : {0.0, 0.5, 0.5, 1.25, 1.25, 1.25, 2.0, 9.0})
        table.append(time_s, {}, 1);
    EXPECT_EQ(table.densestSecond(), 5u);  // 0.5 twice and 1.25 thrice
}

TEST(ScanTable, KeepsPosesAndCountsBytes)
{
    ScanTable table;
    table.append(1, {2, 3, 0.5}, 100);
    table.append(1, {4, 5, -0.5}, 0);
    EXPECT_EQ(table.pose(1).x, 4);
    EXPECT_EQ(table.pose(1).y, 5);
    EXPECT_EQ(table.pose(1).yaw, -0.5);
    // 2 scans of 4 doubles, 3 point offsets of 8 bytes, 2 pages of 4 bytes for 100 points.
    EXPECT_EQ(table.bytes(), 2 * 32u + 3 * 8u + 2 * 4u);
    table.clear();
    EXPECT_TRUE(table.empty());
    EXPECT_EQ(table.pointCount(), 0u);
    table.append(0, {}, 1);  // time may start anew
    EXPECT_EQ(table.scanOf(0), 0u);
}

TEST(ScanTable, RefusesTimesThatAreOlderOrNoNumbers)
{
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    ScanTable table;
    EXPECT_THROW(table.append(kNan, {}, 1), std::invalid_argument);
    table.append(2, {}, 1);
    EXPECT_THROW(table.append(1.5, {}, 1), std::invalid_argument);
    EXPECT_THROW(table.append(kNan, {}, 1), std::invalid_argument);
    table.append(2, {}, 1);
    EXPECT_EQ(table.size(), 2u);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/map/rtob_map.h>

#include <vector>

namespace rtob
{
namespace
{
/// Scan k has k + 1 points with x = k, from a pose with x = 10 k.
void insert(RtobMap& map, int k)
{
    Points points;
    for (int i = 0; i <= k; ++i) points.add(static_cast<float>(-9 * k), 0);
    map.insertScan(map.tick(k), {10.0 * k, 0, 0}, points.view());
}

TEST(RtobMapKeepOnly, IsTheMapOfTheScansThatStay)
{
    RtobMap map, expected;
    std::vector<char> keep;
    for (int k = 0; k < 300; ++k)
    {
        insert(map, k);
        keep.push_back(k % 3 == 1);
        if (keep.back() != 0)
            insert(expected, k);
        else
            expected.tick(k);
    }
    map.keepOnly(keep);
    ASSERT_EQ(map.scans().size(), expected.scans().size());
    ASSERT_EQ(map.size(), expected.size());
    for (std::size_t scan = 0; scan < map.scans().size(); ++scan)
    {
        EXPECT_EQ(map.scans().time(scan), expected.scans().time(scan));
        EXPECT_EQ(map.scans().x(scan), expected.scans().x(scan));
        EXPECT_EQ(map.scans().firstPoint(scan), expected.scans().firstPoint(scan));
        for (auto point = map.scans().firstPoint(scan); point < map.scans().firstPoint(scan + 1);
             ++point)
        {
            EXPECT_EQ(map.scans().scanOf(point), scan);
            EXPECT_EQ(map.points().x[point], expected.points().x[point]);
        }
    }
    EXPECT_EQ(map.clock().now(), expected.clock().now());
    // The index of visits finds the same.
    std::vector<ScanRange> found, expected_found;
    const Box box{500, -1, 900, 1};
    map.view().visits.query(box, map.scans(), 50, found);
    expected.view().visits.query(box, expected.scans(), 50, expected_found);
    ASSERT_EQ(found.size(), expected_found.size());
    for (std::size_t k = 0; k < found.size(); ++k)
    {
        EXPECT_EQ(found[k].first, expected_found[k].first);
        EXPECT_EQ(found[k].end, expected_found[k].end);
    }
}

TEST(RtobMapKeepOnly, TheMapGrowsOnAfterwards)
{
    RtobMap map;
    for (int k = 0; k < 50; ++k) insert(map, k);
    map.keepOnly(std::vector<char>(50, 0));
    EXPECT_EQ(map.size(), 0U);
    EXPECT_EQ(map.scans().size(), 0U);
    insert(map, 50);
    EXPECT_EQ(map.scans().size(), 1U);
    EXPECT_EQ(map.size(), 51U);
    EXPECT_EQ(map.scans().time(0), 50);
}
}  // namespace
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/map_raster.h>
#include <rtob/core/random.h>

#include <algorithm>

namespace rtob
{
namespace
{
/// A map of one scan from a place.
struct Map
{
    Points points;
    ScanTable scans;

    void add(const Points& seen_map, const Pose2& pose_map_vehicle)
    {
        for (std::size_t i = 0; i < seen_map.size(); ++i) points.add(seen_map.x[i], seen_map.y[i]);
        scans.append(0, pose_map_vehicle, static_cast<std::uint32_t>(seen_map.size()));
    }
};

Points two_points()
{
    Points points;
    points.add(0, 0);
    points.add(2, 1);
    return points;
}

TEST(MapRaster, MarksPointsAndTheCellsBeside)
{
    Map map;
    map.add(two_points(), {1, 0.5, 0});
    MapRaster raster;
    EXPECT_TRUE(raster.empty());
    raster.draw(map.points.view(), map.scans);
    const int x = raster.cellX(2), y = raster.cellY(1);
    EXPECT_EQ(raster.mark(0, x, y), MapRaster::kHit);
    EXPECT_EQ(raster.mark(0, x - 1, y + 1), MapRaster::kNear);
    EXPECT_EQ(raster.mark(0, x - 2, y), 0);
    EXPECT_EQ(raster.mark(0, -5, 1000), 0);
    EXPECT_NEAR(raster.middleX(x), 2, raster.cell_m());
}

TEST(MapRaster, SeesAlongBeamsOnly)
{
    Map map;
    Points points;
    points.add(2, 0);
    points.add(0, 2);
    map.add(points, {0, 0, 0});
    MapRaster raster;
    raster.draw(map.points.view(), map.scans);
    EXPECT_TRUE(raster.isSeen(0, raster.cellX(1.0), raster.cellY(0.0)));
    EXPECT_FALSE(raster.isSeen(0, raster.cellX(2.0), raster.cellY(0.0)));  // there it ended
    EXPECT_FALSE(raster.isSeen(0, raster.cellX(1.0), raster.cellY(1.0)));
    EXPECT_TRUE(raster.isSeen(3, raster.cellX(0.55), raster.cellY(-0.1)));
}

TEST(MapRaster, CoarserLevelsHoldTheLargestMark)
{
    Map map;
    Random random(3);
    Points points;
    for (int k = 0; k < 60; ++k)
        points.add(
            static_cast<float>(10 * random.uniform()), static_cast<float>(7 * random.uniform()));
    map.add(points, {5, 3, 0});
    MapRaster raster;
    raster.draw(map.points.view(), map.scans);
    for (int level = 1; level < MapRaster::kLevels; ++level)
        for (int y = -3; y < raster.height(); y += 5)
            for (int x = -3; x < raster.width(); x += 5)
            {
                int largest = 0;
                for (int dy = 0; dy < 1 << level; ++dy)
                    for (int dx = 0; dx < 1 << level; ++dx)
                        largest = std::max(largest, raster.mark(0, x + dx, y + dy));
                // Blocks that begin before the raster may look farther: a bound stays one.
                EXPECT_GE(raster.mark(level, x, y), largest);
                if (x >= 0 && y >= 0)
                {
                    EXPECT_EQ(raster.mark(level, x, y), largest);
                }
            }
}

TEST(MapRaster, CollectsOnePointACellSeenFromTheMiddle)
{
    Map map;
    Points points = two_points();
    points.add(2.02F, 1.0F);  // the same cell as the last one, if the cells begin at -0.1
    map.add(points, {1, 0.5, 0});
    MapRaster raster;
    raster.draw(map.points.view(), map.scans);
    Points around;
    raster.collect({1, 0, 3, 2}, around);
    ASSERT_EQ(around.size(), 1U);
    EXPECT_NEAR(around.x[0], 0.01, 1e-5);
    EXPECT_NEAR(around.y[0], 0, 1e-5);
    raster.collect({5, 5, 6, 6}, around);
    EXPECT_EQ(around.size(), 0U);
}

TEST(MapRaster, AHugeMapGetsLargerCells)
{
    Map map;
    Points points;
    points.add(0, 0);
    points.add(3000, 2000);
    map.add(points, {1, 1, 0});
    MapRaster raster;
    raster.draw(map.points.view(), map.scans);
    EXPECT_LE(
        static_cast<std::size_t>(raster.width()) * static_cast<std::size_t>(raster.height()),
        MapRaster::kMaxCells);
    EXPECT_EQ(raster.mark(0, raster.cellX(3000), raster.cellY(2000)), MapRaster::kHit);
}
}  // namespace
}  // namespace rtob

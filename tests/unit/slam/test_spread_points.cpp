// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/spread_points.h>

#include <cmath>

using rtob::Points;
using rtob::spread_points;

namespace
{
/// Points along x: so many, at this distance from each other.
void add_wall(Points& points, double begin_x, int count, double step_m)
{
    for (int i = 0; i < count; ++i) points.add(static_cast<float>(begin_x + step_m * i), 1);
}

Points spread(const Points& points, std::size_t most)
{
    Points kept;
    spread_points(points.view(), most, kept);
    return kept;
}

std::size_t count_between(const Points& points, float from_x, float to_x)
{
    std::size_t count = 0;
    for (const float x : points.x) count += x >= from_x && x < to_x;
    return count;
}
}  // namespace

TEST(SpreadPoints, KeepsAllOfAFewInTheirOrder)
{
    Points points;
    add_wall(points, 3, 10, -0.1);
    const Points kept = spread(points, 10);
    EXPECT_EQ(kept.x, points.x);
    EXPECT_EQ(kept.y, points.y);
    EXPECT_EQ(spread(Points(), 10).size(), 0u);
}

TEST(SpreadPoints, KeepsAsManyAsAskedFromAnEvenWall)
{
    Points points;
    add_wall(points, 0, 1001, 0.01);
    const Points kept = spread(points, 100);
    EXPECT_LE(kept.size(), 100u);
    EXPECT_GE(kept.size(), 99u);
    for (std::size_t i = 1; i < kept.size(); ++i)
        EXPECT_NEAR(kept.x[i] - kept.x[i - 1], 0.1, 0.011);  // a point's step
}

TEST(SpreadPoints, ACrowdedWallGetsNoMoreThanItsLength)
{
    Points points;
    add_wall(points, 0, 1000, 0.002);  // 2 m with 500 points a metre
    add_wall(points, 2, 100, 0.02);    // 2 m with 50
    const Points kept = spread(points, 100);
    EXPECT_NEAR(static_cast<double>(count_between(kept, 0, 2)), 50, 2);
    EXPECT_NEAR(static_cast<double>(count_between(kept, 2, 4)), 50, 2);
}

TEST(SpreadPoints, AGapCountsAsNoWall)
{
    Points points;
    add_wall(points, 0, 200, 0.01);
    add_wall(points, 50, 200, 0.01);
    const Points kept = spread(points, 100);
    EXPECT_GE(kept.size(), 90u);  // the gap of 48 m takes the place of 0.2 m of wall
    EXPECT_NEAR(
        static_cast<double>(count_between(kept, 0, 10)),
        static_cast<double>(count_between(kept, 40, 60)), 2);
}

TEST(SpreadPoints, PointsInOnePlaceAreNoMoreThanAskedFor)
{
    Points points;
    for (int i = 0; i < 50; ++i) points.add(1, 1);
    EXPECT_LE(spread(points, 10).size(), 10u);
}

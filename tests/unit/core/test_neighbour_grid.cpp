// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/neighbour_grid.h>
#include <rtob/core/random.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

using rtob::NeighbourGrid;
using rtob::Points;

namespace
{
using Coordinate = std::function<float(rtob::Random&)>;

/// The smallest squared distance, -1 if it is beyond the radius. In floats, as the grid computes.
float brute_force(const Points& points, float x, float y, float radius_m)
{
    float best = -1;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const float dx = points.x[i] - x, dy = points.y[i] - y;
        const float d2 = dx * dx + dy * dy;
        if (d2 <= radius_m * radius_m && (best < 0 || d2 < best)) best = d2;
    }
    return best;
}

/// Builds `worlds` grids of random points and compares 1000 queries in each.
void expect_brute_force(int worlds, const Coordinate& coordinate, const Coordinate& radius_share)
{
    rtob::Random random(9);
    NeighbourGrid grid;
    int found = 0;
    for (int world = 0; world < worlds; ++world)
    {
        const auto max_radius_m = static_cast<float>(0.05 + random.uniform());
        Points points;
        for (auto n = 1 + random.below(500); n > 0; --n)
            points.add(coordinate(random), coordinate(random));
        grid.build(points.view(), max_radius_m);
        for (int i = 0; i < 1000; ++i)
        {
            const float x = coordinate(random), y = coordinate(random);
            const float radius_m = max_radius_m * radius_share(random);
            const float expected = brute_force(points, x, y, radius_m);
            const auto neighbour = grid.nearest(x, y, radius_m);
            ASSERT_EQ(neighbour.index == NeighbourGrid::kNone, expected < 0);
            if (expected < 0) continue;
            ++found;
            ASSERT_EQ(neighbour.squared_distance, expected);
            const auto j = static_cast<std::size_t>(neighbour.index);
            const float dx = grid.points().x[j] - x, dy = grid.points().y[j] - y;
            ASSERT_EQ(dx * dx + dy * dy, expected);
        }
    }
    EXPECT_GT(found, 50 * worlds);  // or the cases are all empty
}

float any_share(rtob::Random& random)
{
    return static_cast<float>(random.uniform());
}
float whole(rtob::Random&)
{
    return 1;
}
}  // namespace

TEST(NeighbourGrid, EqualsBruteForceOnUniformPoints)
{
    const auto uniform = [](rtob::Random& random)
    { return static_cast<float>(8 * random.uniform() - 4); };
    expect_brute_force(30, uniform, any_share);
    expect_brute_force(10, uniform, whole);
}

TEST(NeighbourGrid, EqualsBruteForceOnClusters)
{
    expect_brute_force(
        30,
        [](rtob::Random& random)
        {
            const auto cluster = static_cast<double>(random.below(3)) - 1;
            return static_cast<float>(3 * cluster + 0.1 * random.uniform());
        },
        any_share);
}

// Multiples of 1/16 with a radius that makes cells of 1/16: points lie on borders and on each
// other, and many lie at exactly the radius.
TEST(NeighbourGrid, EqualsBruteForceOnCellBordersAndDuplicates)
{
    rtob::Random random(10);
    NeighbourGrid grid;
    const auto coordinate = [&] { return (static_cast<float>(random.below(64)) - 32) / 16; };
    for (int world = 0; world < 20; ++world)
    {
        Points points;
        for (auto n = 1 + random.below(300); n > 0; --n) points.add(coordinate(), coordinate());
        grid.build(points.view(), 0.25);
        for (int i = 0; i < 1000; ++i)
        {
            const float x = coordinate(), y = coordinate();
            const float radius_m = static_cast<float>(random.below(5)) / 16;
            const float expected = brute_force(points, x, y, radius_m);
            const auto neighbour = grid.nearest(x, y, radius_m);
            ASSERT_EQ(neighbour.index == NeighbourGrid::kNone, expected < 0);
            if (expected < 0) continue;
            ASSERT_EQ(neighbour.squared_distance, expected);
        }
    }
}

// 16 to 64 cells of at most 0.26 m make a table of a few metres; points lie over kilometres.
TEST(NeighbourGrid, EqualsBruteForceFarBeyondItsTable)
{
    expect_brute_force(
        20,
        [](rtob::Random& random)
        {
            const auto hall = static_cast<double>(random.below(2));
            return static_cast<float>(3000 * hall - 1500 + 2 * random.uniform());
        },
        any_share);
}

// A table of 64 x 64 cells of 12.5 mm, and radii beyond its width.
TEST(NeighbourGrid, EqualsBruteForceWithRadiiWiderThanItsTable)
{
    rtob::Random random(11);
    NeighbourGrid grid;
    const auto coordinate = [&] { return static_cast<float>(6 * random.uniform() - 3); };
    for (int world = 0; world < 20; ++world)
    {
        Points points;
        for (auto n = 1 + random.below(30); n > 0; --n) points.add(coordinate(), coordinate());
        grid.build(points.view(), 0.1);
        for (int i = 0; i < 100; ++i)
        {
            const float x = coordinate(), y = coordinate();
            const auto radius_m = static_cast<float>(2 * random.uniform());
            const float expected = brute_force(points, x, y, radius_m);
            const auto neighbour = grid.nearest(x, y, radius_m);
            ASSERT_EQ(neighbour.index == NeighbourGrid::kNone, expected < 0);
            ASSERT_TRUE(expected < 0 || neighbour.squared_distance == expected);
            float within = 0;
            for (std::size_t j = 0; j < points.size(); ++j)
            {
                const float dx = points.x[j] - x, dy = points.y[j] - y;
                within += dx * dx + dy * dy <= radius_m * radius_m ? 1.0f : 0.0f;
            }
            ASSERT_EQ(grid.sumsNear(x, y, radius_m).n, within);
        }
    }
}

TEST(NeighbourGrid, FindsNothingWhereNothingIs)
{
    NeighbourGrid grid;
    grid.build({}, 0.3);
    EXPECT_EQ(grid.nearest(0, 0, 0.3f).index, NeighbourGrid::kNone);
    Points points;
    points.add(0, 0);
    grid.build(points.view(), 0.3);
    EXPECT_EQ(grid.nearest(0.31f, 0, 0.3f).index, NeighbourGrid::kNone);
    EXPECT_EQ(grid.nearest(0.1f, 0, 0.05f).index, NeighbourGrid::kNone);
    EXPECT_EQ(grid.nearest(0.3f, 0, 0.3f).index, 0);  // the radius itself is in
    EXPECT_EQ(grid.nearest(0, 0, 0).index, 0);
}

TEST(NeighbourGrid, FindsNothingWhereNoNumberIs)
{
    Points points;
    points.add(0, 0);
    NeighbourGrid grid;
    grid.build(points.view(), 0.3);
    for (const float v : {std::nanf(""), INFINITY, -INFINITY, 1e30f, -1e30f})
    {
        EXPECT_EQ(grid.nearest(v, 0, 0.3f).index, NeighbourGrid::kNone);
        EXPECT_EQ(grid.nearest(0, v, 0.3f).index, NeighbourGrid::kNone);
    }
}

TEST(NeighbourGrid, KeepsEachPointAndItsOrigin)
{
    rtob::Random random(1);
    Points points;
    for (int i = 0; i < 500; ++i)
        points.add(
            static_cast<float>(4 * random.uniform()), static_cast<float>(4 * random.uniform()));
    NeighbourGrid grid;
    grid.build(points.view(), 0.3);
    std::vector<bool> seen(points.size());
    for (std::int32_t i = 0; i < 500; ++i)
    {
        const std::size_t original = grid.original(i);
        EXPECT_EQ(grid.points().x[static_cast<std::size_t>(i)], points.x[original]);
        EXPECT_EQ(grid.points().y[static_cast<std::size_t>(i)], points.y[original]);
        EXPECT_FALSE(seen[original]);
        seen[original] = true;
    }
}

TEST(NeighbourGrid, SumsCountEachPointWithinTheRadiusOnce)
{
    rtob::Random random(2);
    Points points;
    // 16 m: the table of 64 cells of 37 mm wraps around many times.
    for (int i = 0; i < 4000; ++i)
        points.add(
            static_cast<float>(16 * random.uniform()), static_cast<float>(2 * random.uniform()));
    NeighbourGrid grid;
    grid.build(points.view(), 0.3);
    for (int query = 0; query < 200; ++query)
    {
        const auto x = static_cast<float>(16 * random.uniform());
        const auto y = static_cast<float>(2 * random.uniform());
        double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const float dx = points.x[i] - x, dy = points.y[i] - y;
            if (dx * dx + dy * dy > 0.3f * 0.3f) continue;
            n += 1, sx += dx, sy += dy, sxx += dx * dx, sxy += dx * dy, syy += dy * dy;
        }
        const auto sums = grid.sumsNear(x, y, 0.3f);
        EXPECT_EQ(sums.n, n);
        EXPECT_NEAR(sums.x, sx, 1e-5);
        EXPECT_NEAR(sums.y, sy, 1e-5);
        EXPECT_NEAR(sums.xx, sxx, 1e-5);
        EXPECT_NEAR(sums.xy, sxy, 1e-5);
        EXPECT_NEAR(sums.yy, syy, 1e-5);
    }
}

TEST(NeighbourGrid, RefusesARadiusOfNothing)
{
    NeighbourGrid grid;
    EXPECT_THROW(grid.build({}, 0), std::invalid_argument);
    EXPECT_THROW(grid.build({}, -1), std::invalid_argument);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/avoid/convex_area.h>
#include <rtob/core/random.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rtob;
using Eigen::Vector2d;

namespace
{
ConvexArea hull(const std::vector<Vector2d>& points)
{
    ConvexArea area;
    area.hullOf(points.data(), points.size());
    return area;
}

Vector2d random_point(Random& random)
{
    return {4 * random.uniform() - 2, 4 * random.uniform() - 2};
}
}  // namespace

TEST(ConvexArea, OfASquareDropsInnerPointsAndThoseOnItsSides)
{
    const ConvexArea square = hull({{0, 0}, {1, 1}, {0.5, 0.5}, {1, 0}, {0.5, 0}, {0, 1}, {0, 0}});
    EXPECT_EQ(square.size(), 4u);
    EXPECT_EQ(square.squaredDistance({0.3, 0.9}), 0);
    EXPECT_DOUBLE_EQ(square.squaredDistance({3, 0.5}), 4);
    EXPECT_DOUBLE_EQ(square.squaredDistance({2, 2}), 2);
}

TEST(ConvexArea, MayBeAPointOrASegment)
{
    const ConvexArea point = hull({{1, 2}, {1, 2}});
    EXPECT_EQ(point.size(), 1u);
    EXPECT_DOUBLE_EQ(point.squaredDistance({1, 5}), 9);
    const ConvexArea segment = hull({{0, 0}, {2, 0}, {1, 0}});
    EXPECT_EQ(segment.size(), 2u);
    EXPECT_DOUBLE_EQ(segment.squaredDistance({1, -2}), 4);
    EXPECT_EQ(segment.squaredDistance({1.5, 0}), 0);
}

TEST(ConvexArea, WithinIsOpen)
{
    const ConvexArea point = hull({{0, 0}});
    EXPECT_FALSE(point.isWithin({1, 0}, 1));
    EXPECT_TRUE(point.isWithin({1, 0}, 1.001));
}

// No mixture of the points is nearer than the hull, and the nearest of many is about as near.
TEST(ConvexArea, DistanceIsThatOfTheNearestMixture)
{
    Random random(1);
    for (int round = 0; round < 50; ++round)
    {
        std::vector<Vector2d> points;
        for (std::size_t i = 0; i < 3 + random.below(6); ++i)
            points.push_back(random_point(random));
        const ConvexArea area = hull(points);
        const Vector2d place = 2 * random_point(random);
        double nearest = 1e9;
        for (int i = 0; i < 4000; ++i)
        {
            // A mixture of two random points of random mixtures lies anywhere in the hull.
            const auto pick = [&] { return points[random.below(points.size())]; };
            const double a = random.uniform(), b = random.uniform();
            const Vector2d mixed = b * (a * pick() + (1 - a) * pick()) + (1 - b) * pick();
            nearest = std::min(nearest, (mixed - place).norm());
        }
        const double distance = std::sqrt(area.squaredDistance(place));
        EXPECT_LE(distance, nearest + 1e-9) << "round " << round;
        EXPECT_NEAR(distance, nearest, 0.15) << "round " << round;  // as dense as the mixtures are
    }
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/sim/shape.h>

using namespace rtob::sim;

namespace
{
constexpr double pi = 3.14159265358979323846;
}

TEST(SimShape, DistanceToASegmentIsToItsNearestPoint)
{
    const Segment segment{{0, 0}, {4, 0}};
    EXPECT_DOUBLE_EQ(distance({1, 3}, segment), 3);   // above it
    EXPECT_DOUBLE_EQ(distance({7, 4}, segment), 5);   // 3, 4, 5 beyond its end
    EXPECT_DOUBLE_EQ(distance({-1, 0}, segment), 1);  // before its start
    EXPECT_DOUBLE_EQ(distance({1, 1}, Segment{{1, 0}, {1, 0}}), 1);
}

TEST(SimShape, DistanceToAnArcLooksAtItsEndsToo)
{
    const Arc upper{{0, 0}, 2, 0, pi};
    EXPECT_DOUBLE_EQ(distance({0, 5}, upper), 3);
    EXPECT_DOUBLE_EQ(distance({0, 1}, upper), 1);
    // Below it the ends at (2, 0) and (-2, 0) are nearest.
    EXPECT_DOUBLE_EQ(distance({2, -3}, upper), 3);
    EXPECT_DOUBLE_EQ(distance({0, 0}, Arc{{0, 0}, 2}), 2);
}

TEST(SimShape, AnArcKnowsItsAnglesAcrossTheWrap)
{
    const Arc back{{0, 0}, 1, 0.75 * pi, 0.5 * pi};  // 135 to 225 degrees
    EXPECT_TRUE(back.has(pi));
    EXPECT_TRUE(back.has(-pi));
    EXPECT_TRUE(back.has(-0.8 * pi));
    EXPECT_FALSE(back.has(-0.7 * pi));
    EXPECT_FALSE(back.has(0));
    EXPECT_TRUE((Arc{{0, 0}, 1}.has(-3)));
}

TEST(SimShape, MovesAsARigidBody)
{
    const rtob::Pose2 motion{1, 2, pi / 2};
    const auto segment = std::get<Segment>(moved(Segment{{1, 0}, {2, 0}}, motion));
    EXPECT_NEAR(segment.from.x, 1, 1e-12);
    EXPECT_NEAR(segment.from.y, 3, 1e-12);
    EXPECT_NEAR(segment.to.y, 4, 1e-12);
    const auto arc = std::get<Arc>(moved(Arc{{1, 0}, 0.5, 0.1, 0.2}, motion));
    EXPECT_NEAR(arc.centre.y, 3, 1e-12);
    EXPECT_DOUBLE_EQ(arc.from_rad, 0.1 + pi / 2);
    EXPECT_DOUBLE_EQ(arc.sweep_rad, 0.2);
}

TEST(SimShape, APointIsInsideWhereTheOutlineIsCrossedAnOddNumberOfTimes)
{
    const Segment sides[] = {
        {{0, 0}, {2, 0}}, {{2, 0}, {2, 1}}, {{2, 1}, {0, 1}}, {{0, 1}, {0, 0}}};
    const auto count = [&](Point2 point)
    {
        int crossed = 0;
        for (const auto& side : sides) crossed += crossings(point, side);
        return crossed;
    };
    EXPECT_EQ(count({0.3, 0.4}) % 2, 1);
    EXPECT_EQ(count({1.9, 0.9}) % 2, 1);
    EXPECT_EQ(count({-0.5, -0.5}) % 2, 0);
    EXPECT_EQ(count({2.1, 0.5}) % 2, 0);
    EXPECT_EQ(crossings({0.2, 0.1}, Arc{{0, 0}, 1}), 1);
    EXPECT_EQ(crossings({-3, -3 * std::tan(0.7391)}, Arc{{0, 0}, 1}), 2);
    EXPECT_EQ(crossings({3, 3}, Arc{{0, 0}, 1}), 0);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/avoid/near_obstacles.h>

using namespace rtob;
using Eigen::Vector2d;

namespace
{
/// From the vehicle to 2 m ahead.
ConvexArea two_metres_ahead()
{
    const std::array<Vector2d, 2> ends{Vector2d(0, 0), Vector2d(2, 0)};
    ConvexArea area;
    area.hullOf(ends.data(), ends.size());
    return area;
}
}  // namespace

TEST(NearObstacles, ExcusesWhatIsTooNearToAnAreaAndHandsItOver)
{
    NearObstacles obstacles, excused;
    obstacles.add({{1, 0.3}, 0.5});   // 0.3 m beside the area
    obstacles.add({{1, -0.6}, 0.5});  // far enough
    obstacles.add({{2.4, 0}, 0.5});   // 0.4 m behind its end
    obstacles.excuse(two_metres_ahead(), excused);
    EXPECT_NEAR(obstacles.at(0).keep_m, 0.3, 1e-4);
    EXPECT_EQ(obstacles.at(1).keep_m, 0.5);
    EXPECT_NEAR(obstacles.at(2).keep_m, 0.4, 1e-4);
    EXPECT_FALSE(obstacles.anyIsIn(two_metres_ahead()));
    ASSERT_EQ(excused.size(), 2u);
    EXPECT_NEAR(excused.at(0).place_vehicle.y(), 0.3, 1e-6);
    EXPECT_NEAR(excused.at(1).place_vehicle.x(), 2.4, 1e-6);
}

TEST(NearObstacles, LieAheadOfHalfOfAllDirections)
{
    NearObstacles obstacles;
    EXPECT_FALSE(obstacles.anyIsAhead({1, 0}));
    obstacles.add({{1, 1}, 0.5});
    EXPECT_TRUE(obstacles.anyIsAhead({1, 0}));
    EXPECT_TRUE(obstacles.anyIsAhead({-0.9, 1}));
    EXPECT_FALSE(obstacles.anyIsAhead({-1.1, 1}));
    EXPECT_FALSE(obstacles.anyIsAhead({-1, -1}));
    EXPECT_FALSE(obstacles.anyIsAhead({0, 0}));
    obstacles.add({{-1, 0}, 0.5});
    EXPECT_TRUE(obstacles.anyIsAhead({-1.1, 1}));
}

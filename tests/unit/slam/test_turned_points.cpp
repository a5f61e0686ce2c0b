// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/turned_points.h>

#include "room.h"

using rtob::Box;
using rtob::Points;
using rtob::Pose2;

namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double kFloat_m = 2e-6;  // points are floats, a few metres away
}  // namespace

TEST(TurnPoints, TurnsAndDoesNotShift)
{
    Points points_vehicle, points_turned;
    points_vehicle.add(2, 0);
    points_vehicle.add(0, 1);
    const Box box = rtob::turn_points({10, 20, pi / 2}, points_vehicle.view(), points_turned);
    ASSERT_EQ(points_turned.size(), 2U);
    EXPECT_NEAR(points_turned.x[0], 0, kFloat_m);
    EXPECT_NEAR(points_turned.y[0], 2, kFloat_m);
    EXPECT_NEAR(points_turned.x[1], -1, kFloat_m);
    EXPECT_NEAR(points_turned.y[1], 0, kFloat_m);
    // The box is in map, and holds the vehicle itself.
    EXPECT_NEAR(box.min_x, 9, kFloat_m);
    EXPECT_NEAR(box.max_x, 10, kFloat_m);
    EXPECT_NEAR(box.min_y, 20, kFloat_m);
    EXPECT_NEAR(box.max_y, 22, kFloat_m);
}

TEST(TurnPoints, WithTheShiftIsEquationTwo)
{
    for (const Pose2& pose : {Pose2{}, Pose2{1, 0.5, 1e-8}, Pose2{1.2, 1, -2.2}, Pose2{3, 1, pi}})
    {
        const Points points_vehicle = rtob::test::room_4x3().scan_vehicle(pose);
        const Points points_map = rtob::test::moved(points_vehicle, pose);
        Points points_turned;
        const Box box = rtob::turn_points(pose, points_vehicle.view(), points_turned);
        ASSERT_EQ(points_turned.size(), points_map.size());
        for (std::size_t i = 0; i < points_map.size(); ++i)
        {
            EXPECT_NEAR(pose.x + points_turned.x[i], points_map.x[i], kFloat_m);
            EXPECT_NEAR(pose.y + points_turned.y[i], points_map.y[i], kFloat_m);
            EXPECT_TRUE(box.grown(kFloat_m).contains(points_map.x[i], points_map.y[i]));
        }
    }
}

TEST(TurnPoints, ReplacesWhatWasThereAndTakesNoPoints)
{
    Points points_turned;
    points_turned.add(1, 1);
    const Box box = rtob::turn_points({4, 5, 1}, Points().view(), points_turned);
    EXPECT_EQ(points_turned.size(), 0U);
    EXPECT_EQ(box.min_x, 4);
    EXPECT_EQ(box.max_x, 4);
    EXPECT_EQ(box.min_y, 5);
    EXPECT_EQ(box.max_y, 5);
}

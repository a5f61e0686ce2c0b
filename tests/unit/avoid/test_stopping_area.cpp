// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/avoid/stopping_area.h>
#include <Eigen/Geometry>

#include <algorithm>

using namespace rtob;
using Eigen::Vector2d;

namespace
{
/// Brakes with 2 m/s2 after 0.3 s; decides every 0.1 s and answers with 0.2 s.
VehicleLimits limits()
{
    VehicleLimits limits;
    limits.acceleration_mps2 = 4;
    limits.derating = 0.5;
    limits.latency_s = 0.3;
    limits.period_s = 0.1;
    limits.response_s = 0.2;
    return limits;
}

double farthest_x(const ConvexArea& area)
{
    double x = -1e9;
    for (const Vector2d& corner : area) x = std::max(x, corner.x());
    return x;
}

StoppingArea area_with(const Vector2d& velocity)
{
    StoppingArea area(limits());
    area.setActing(&velocity, 1);
    return area;
}
}  // namespace

TEST(StoppingArea, OfRestIsAPoint)
{
    EXPECT_EQ(area_with({0, 0}).of({0, 0}).size(), 1u);
}

// Latency 0.3 s, response 0.2 s, 2 / (2 * 2) s of braking: 1 s of 2 m/s.
TEST(StoppingArea, OfAStopIsTheStoppingDistance)
{
    const ConvexArea area = area_with({2, 0}).of({0, 0});
    EXPECT_NEAR(farthest_x(area), 2.0, 1e-12);
    EXPECT_EQ(area.size(), 2u);
}

// The same and one more period of 0.1 s.
TEST(StoppingArea, OfGoingOnIsOnePeriodLonger)
{
    EXPECT_NEAR(farthest_x(area_with({2, 0}).of({2, 0})), 2.2, 1e-12);
}

TEST(StoppingArea, FromRestHoldsTheCommandsOwnStop)
{
    // 0.3 + 0.1 + 0.2 + 1 / (2 * 2) s of 1 m/s
    EXPECT_NEAR(farthest_x(area_with({0, 0}).of({1, 0})), 0.85, 1e-12);
}

TEST(StoppingArea, HoldsWhatWasCommandedBeforeAndNotYetDone)
{
    StoppingArea area(limits());
    const Vector2d acting[] = {{0, 0}, {2, 0}};
    area.setActing(acting, 2);
    EXPECT_NEAR(farthest_x(area.of({0, 0})), 2.0, 1e-12);
}

TEST(StoppingArea, TurnsWithItsVelocities)
{
    const Eigen::Rotation2Dd turn(0.7);
    const ConvexArea straight = area_with({1, 0.5}).of({0.3, -1});
    const ConvexArea turned = area_with(turn * Vector2d(1, 0.5)).of(turn * Vector2d(0.3, -1));
    for (const Vector2d& corner : straight)
        EXPECT_NEAR(turned.squaredDistance(turn * corner), 0, 1e-18);
}

TEST(StoppingArea, IsWithinItsReach)
{
    const auto area = area_with({1.5, -0.3});
    for (const Vector2d& command : {Vector2d(1, 0), Vector2d(-1, 0), Vector2d(0, 1)})
        for (const Vector2d& corner : area.of(command)) EXPECT_LE(corner.norm(), area.reach(1.0));
}

TEST(VehicleLimits, RefuseValuesOutOfRange)
{
    VehicleLimits bad = limits();
    bad.derating = 1.1;
    EXPECT_THROW(bad.validate(), std::invalid_argument);
    bad = limits();
    bad.acceleration_mps2 = 0;
    EXPECT_THROW(bad.validate(), std::invalid_argument);
}

TEST(VehicleLimits, JerkAddsToTheResponse)
{
    VehicleLimits slow = limits();
    slow.jerk_mps3 = 20;
    EXPECT_NEAR(slow.response(), 0.2 + 1.5 * 4 / 20, 1e-12);
}

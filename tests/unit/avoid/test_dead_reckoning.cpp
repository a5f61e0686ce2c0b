// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/avoid/dead_reckoning.h>

using namespace rtob;

namespace
{
VehicleMotion motion(double forward_mps, double left_mps, double yaw_rate_radps)
{
    return {{forward_mps, left_mps}, yaw_rate_radps};
}
}  // namespace

TEST(DeadReckoning, SumsVelocitiesUp)
{
    DeadReckoning reckoning;
    for (int i = 0; i <= 10; ++i) reckoning.add(0.1 * i, motion(1, -0.5, 0));
    EXPECT_NEAR(reckoning.poseAt(1.0)->x, 1.0, 1e-12);
    EXPECT_NEAR(reckoning.poseAt(1.0)->y, -0.5, 1e-12);
    EXPECT_NEAR(reckoning.poseAt(0.25)->x, 0.25, 1e-12);
    EXPECT_NEAR(reckoning.poseAt(1.2)->x, 1.2, 1e-12);
    EXPECT_NEAR(reckoning.poseAt(-0.2)->x, -0.2, 1e-12);
}

// 1 m/s along a circle of 1 m: after a quarter turn at (1, 1).
TEST(DeadReckoning, FollowsACircle)
{
    DeadReckoning reckoning;
    const double quarter_s = M_PI / 2;
    for (int i = 0; i <= 100; ++i) reckoning.add(quarter_s * i / 100, motion(1, 0, 1));
    EXPECT_NEAR(reckoning.newest().x, 1.0, 1e-4);  // a hundredth of a turn's sagitta, squared
    EXPECT_NEAR(reckoning.newest().y, 1.0, 1e-4);
    EXPECT_NEAR(reckoning.newest().yaw, M_PI / 2, 1e-9);
}

TEST(DeadReckoning, StartsAnewAfterAGapAndWhenTimeRunsBack)
{
    DeadReckoning reckoning;
    EXPECT_FALSE(reckoning.poseAt(0).has_value());
    EXPECT_TRUE(reckoning.add(10, motion(1, 0, 0)));
    EXPECT_TRUE(reckoning.add(10.5, motion(1, 0, 0)));
    EXPECT_FALSE(reckoning.add(12, motion(1, 0, 0)));
    EXPECT_FALSE(reckoning.poseAt(10.2).has_value());
    EXPECT_FALSE(reckoning.add(11.9, motion(1, 0, 0)));
    EXPECT_EQ(reckoning.newest().x, 0);
}

TEST(DeadReckoning, KnowsNothingFarAheadNorFarBack)
{
    DeadReckoning reckoning;
    for (int i = 0; i < 1000; ++i) reckoning.add(0.02 * i, motion(1, 0, 0));
    EXPECT_FALSE(reckoning.poseAt(5.0).has_value());
    EXPECT_FALSE(reckoning.poseAt(25.0).has_value());
    EXPECT_NEAR(reckoning.poseAt(19.0)->x, 19.0, 1e-9);
    EXPECT_FALSE(reckoning.poseAt(std::nan("")).has_value());
}

TEST(DeadReckoning, TakesTwoMeasurementsOfOneMoment)
{
    DeadReckoning reckoning;
    reckoning.add(1, motion(1, 0, 0));
    EXPECT_TRUE(reckoning.add(1, motion(2, 0, 0)));
    EXPECT_NEAR(reckoning.poseAt(1.1)->x, 0.2, 1e-12);
}

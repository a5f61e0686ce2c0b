// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/drivers/pose_carrier.h>

namespace rtob
{
namespace
{
const Eigen::Matrix3d small = 1e-4 * Eigen::Matrix3d::Identity();

TEST(PoseCarrier, CarriesOnAtConstantVelocity)
{
    PoseCarrier carrier;
    carrier.matched(10.0, {0, 0, 0}, small);
    carrier.matched(10.1, {0.1, 0, 0}, small);
    const auto pose = carrier.at(10.15);
    ASSERT_TRUE(pose);
    EXPECT_EQ(10.15, pose->time_s);
    EXPECT_NEAR(0.15, pose->pose_map_vehicle.x, 1e-12);
    EXPECT_NEAR(1.0, pose->velocity_vehicle.x, 1e-9);
}

TEST(PoseCarrier, CovarianceGrowsWithTheTimeUnseen)
{
    PoseCarrier carrier(0.5);
    carrier.matched(10.0, {0, 0, 0}, small);
    EXPECT_EQ(small, carrier.at(10.0)->covariance);
    const double soon = carrier.at(10.1)->covariance(0, 0);
    const double late = carrier.at(10.3)->covariance(0, 0);
    EXPECT_GT(soon, small(0, 0));
    EXPECT_NEAR(1e-4 + 0.5 * 3 * 0.09 * 0.5 * 3 * 0.09, late, 1e-9);  // (a t^2 / 2)^2
}

TEST(PoseCarrier, GivesNothingOldUnderANewTime)
{
    PoseCarrier carrier(0.3);
    EXPECT_FALSE(carrier.at(10));
    carrier.matched(10.0, {0, 0, 0}, small);
    EXPECT_TRUE(carrier.at(10.29));
    EXPECT_FALSE(carrier.at(10.31));
    EXPECT_FALSE(carrier.at(9.99)) << "the past";
    carrier.lost();
    EXPECT_FALSE(carrier.at(10.1));
}

TEST(PoseCarrier, CountsJumpsOnly)
{
    PoseCarrier carrier;
    for (int i = 0; i <= 10; ++i) carrier.matched(10 + 0.1 * i, {0.1 * i, 0, 0}, small);
    EXPECT_EQ(0, carrier.last()->resets);
    carrier.matched(11.1, {1.6, 0, 0}, small);  // 0.5 m where 0.1 was due
    EXPECT_EQ(1, carrier.last()->resets);
    carrier.matched(11.2, {1.7, 0, 0}, small);
    EXPECT_EQ(1, carrier.last()->resets);
    carrier.lost();
    carrier.matched(12.0, {1.7, 0, 0}, small);
    EXPECT_EQ(2, carrier.last()->resets) << "found again, perhaps elsewhere";
    carrier.matched(12.1, {1.7, 0, 1.0}, small);
    carrier.matched(12.2, {1.7, 0, 1.0}, small);
    EXPECT_EQ(3, carrier.last()->resets) << "1 rad a step, then none: one surprise";
}

TEST(PoseCarrier, PassesOverStampsOfThePast)
{
    PoseCarrier carrier;
    carrier.matched(10.0, {0, 0, 0}, small);
    carrier.matched(10.0, {5, 0, 0}, small);
    carrier.matched(9.0, {5, 0, 0}, small);
    EXPECT_EQ(0, carrier.last()->pose_map_vehicle.x);
}
}  // namespace
}  // namespace rtob

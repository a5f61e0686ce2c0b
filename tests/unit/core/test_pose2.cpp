// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <near_pose.h>
#include <rtob/core/icp.h>
#include <rtob/core/pose2.h>
#include <rtob/core/random.h>

#include <cmath>
#include <vector>

using rtob::Pose2;
using rtob::test::IsNearPose;

namespace
{
constexpr double kPi = 3.14159265358979323846;

/// Identity, tiny, at both ends of the wrap, and random ones within 100 m.
std::vector<Pose2> poses()
{
    std::vector<Pose2> all{
        {0, 0, 0}, {1e-8, -1e-8, 1e-8}, {3, -2, -kPi}, {-3, 2, std::nextafter(kPi, 0)}};
    rtob::Random random(1);
    const auto within = [&](double limit) { return limit * (2 * random.uniform() - 1); };
    for (int i = 0; i < 30; ++i) all.push_back({within(100), within(100), within(kPi)});
    return all;
}
}  // namespace

TEST(WrapAngle, StaysInsideTheHalfOpenTurn)
{
    EXPECT_EQ(rtob::wrap_angle(kPi), -kPi);
    EXPECT_EQ(rtob::wrap_angle(-kPi), -kPi);
    EXPECT_NEAR(rtob::wrap_angle(3.5 * kPi), -0.5 * kPi, 1e-15);
    EXPECT_NEAR(rtob::wrap_angle(-3.5 * kPi), 0.5 * kPi, 1e-15);
    for (const double turns : {-1e6, -3.0, -1.0, 0.0, 1.0, 2.0, 1e6})
        for (const double angle :
             {kPi, -kPi, std::nextafter(kPi, 0), std::nextafter(-kPi, -4), 1.0})
        {
            const double wrapped = rtob::wrap_angle(angle + turns * 2 * kPi);
            EXPECT_GE(wrapped, -kPi) << angle << " + " << turns << " turns";
            EXPECT_LT(wrapped, kPi) << angle << " + " << turns << " turns";
        }
}

TEST(WrapAngle, KeepsTheBitsOfAWrappedAngle)
{
    for (const Pose2& pose : poses()) EXPECT_EQ(rtob::wrap_angle(pose.yaw), pose.yaw);
}

TEST(Pose2, ComposesAsComputedByHand)
{
    // 1 m ahead of a vehicle at (2, 3) that looks along +y is (2, 4); a quarter turn more is +-pi.
    EXPECT_THAT(
        rtob::compose({2, 3, kPi / 2}, {1, 0, kPi / 2}),
        IsNearPose(Pose2{2, 4, kPi}, 1e-15, 1e-15));
}

TEST(Pose2, AnInverseUndoesFromBothSides)
{
    for (const Pose2& pose : poses())
    {
        EXPECT_THAT(rtob::compose(pose, rtob::inverse(pose)), IsNearPose(Pose2{}, 1e-12, 1e-12));
        EXPECT_THAT(rtob::compose(rtob::inverse(pose), pose), IsNearPose(Pose2{}, 1e-12, 1e-12));
    }
}

TEST(Pose2, CompositionIsAssociative)
{
    const auto all = poses();
    for (std::size_t i = 2; i < all.size(); ++i)
    {
        const Pose2 &a = all[i - 2], &b = all[i - 1], &c = all[i];
        EXPECT_THAT(
            rtob::compose(rtob::compose(a, b), c),
            IsNearPose(rtob::compose(a, rtob::compose(b, c)), 1e-12, 1e-12));
    }
}

TEST(Pose2, BetweenChainsToTheSecondPose)
{
    const auto all = poses();
    for (const Pose2& a : all)
        for (const Pose2& b : all)
            EXPECT_THAT(rtob::compose(a, rtob::between(a, b)), IsNearPose(b, 1e-12, 1e-12));
}

// The correction C is seen from the pre-aligned position p with the map's axes. A point of the map
// goes through p, C and back: T = Trans(p) C Trans(-p) T_init. Applied to T_init's own position,
// Trans(-p) gives the origin, C shifts it by (x_icp, y_icp) and Trans(p) adds p: eq. 4.
TEST(Pose2, IsNearWithinBothLimitsAndAcrossTheWrap)
{
    const Pose2 place{1, 2, kPi - 0.01};
    EXPECT_TRUE(is_near(place, {1.3, 2.4, -kPi + 0.01}, 0.51, 0.03));
    EXPECT_FALSE(is_near(place, {1.3, 2.4, -kPi + 0.01}, 0.49, 0.03));
    EXPECT_FALSE(is_near(place, {1.3, 2.4, -kPi + 0.01}, 0.51, 0.01));
    EXPECT_FALSE(is_near(place, place, 0, 1)) << "less than the limit";
}

TEST(ApplyCorrection, EqualsCompositionInSe2)
{
    for (const Pose2& init : poses())
        for (const Pose2& correction : poses())
        {
            const Pose2 to_position{init.x, init.y, 0};
            const Pose2 se2 = rtob::compose(
                rtob::compose(to_position, correction),
                rtob::compose(rtob::inverse(to_position), init));
            EXPECT_THAT(rtob::apply_correction(init, correction), IsNearPose(se2, 1e-12, 1e-12));
        }
}

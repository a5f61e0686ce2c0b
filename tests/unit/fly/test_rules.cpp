// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <guard_world.h>
#include <holonomic.h>
#include <rules.h>

using namespace rtob;
using namespace rtob::fly;
using Eigen::Vector2d;

namespace
{
/// A wall 2 m ahead, nothing else within reach.
test::RoomScan wall_ahead()
{
    return {test::Room({{2, -4, 2, 4}}), {}, 0};
}

GuardDecision decided(Avoider& rule, double now_s, const Vector2d& wish)
{
    const auto seen = wall_ahead();
    rule.observe(seen.scan, {});
    return rule.decide(now_s, wish, {});
}
}  // namespace

TEST(CollisionPrevention, SlowsTowardsAWallAndNotAlongIt)
{
    CollisionPrevention rule{VehicleLimits()};
    // 2 - 0.6 m left, 2 m/s2 and 4 m/s3: v^2 + (4 a^2 / j) v - 2 a d = 0, so v^2 + 4 v - 5.6 = 0.
    const double speed = decided(rule, 0.05, {2, 0}).velocity_vehicle.norm();
    EXPECT_NEAR(speed, 1.098, 0.01);
    EXPECT_EQ(decided(rule, 0.05, {-1, 0}).velocity_vehicle, Vector2d(-1, 0));
}

TEST(CollisionPrevention, StopsWithOldData)
{
    CollisionPrevention rule{VehicleLimits()};
    EXPECT_TRUE(decided(rule, 0.6, {1, 0}).velocity_vehicle.isZero());
}

// Only the left half is seen.
TEST(CollisionPrevention, DoesNotFlyWhereNothingIsKnown)
{
    const auto seen = wall_ahead();
    GuardScan left = seen.scan;
    left.beams = 181;
    CollisionPrevention rule{VehicleLimits()};
    rule.observe(left, {});
    EXPECT_TRUE(rule.decide(0.05, {0, -1}, {}).velocity_vehicle.isZero());
    EXPECT_EQ(rule.decide(0.05, {-0.5, 0.5}, {}).velocity_vehicle, Vector2d(-0.5, 0.5));
    // A little into the unknown: guided to what was seen.
    const GuardDecision bent = rule.decide(0.05, {0.5, -0.1}, {});
    EXPECT_GT(bent.bend_rad, 5 * M_PI / 180);
    EXPECT_GT(bent.velocity_vehicle.norm(), 0);
}

TEST(SimpleAvoidance, CapsTheSpeedTowardsAWallOnly)
{
    SimpleAvoidance rule{VehicleLimits()};
    // sqrt(2 * 1 * (1.4 - 0.5)) towards the wall; along it as wished.
    const Vector2d velocity = decided(rule, 0.05, {1.9, 0.5}).velocity_vehicle;
    EXPECT_NEAR(velocity.x(), std::sqrt(1.8), 0.02);
    EXPECT_NEAR(velocity.y(), 0.5, 0.02);
}

TEST(SimpleAvoidance, DoesNotLimitWithoutData)
{
    SimpleAvoidance rule{VehicleLimits()};
    EXPECT_EQ(decided(rule, 0.6, {1, 0}).velocity_vehicle, Vector2d(1, 0));
}

TEST(SectorRanges, KeepTheNearestOfEachSector)
{
    const auto seen = wall_ahead();
    SectorRanges ranges(8);
    ranges.take(seen.scan);
    EXPECT_NEAR(ranges.at(0).range_m, 2, 1e-6);
    EXPECT_NEAR(ranges.at(1).range_m, 2 / std::cos(23 * M_PI / 180), 1e-3);
    EXPECT_EQ(ranges.at(4).range_m, 6);
    EXPECT_EQ(ranges.sectorAt(-0.1), 0);
    EXPECT_EQ(ranges.sectorAt(-0.5), 7);
}

TEST(FreeWays, EndWhereADiscTouches)
{
    const auto seen = wall_ahead();
    const auto ways = free_ways(seen.scan, 0.6, 120, 4);
    EXPECT_NEAR(ways[60], 1.4, 0.01);  // 1.5 degrees off straight ahead
    EXPECT_EQ(ways[0], 4);             // backwards
    const double slant_rad = (80 + 0.5) * 2 * M_PI / 120 - M_PI;
    EXPECT_NEAR(ways[80], 1.4 / std::cos(slant_rad), 0.05);
}

TEST(FreeWays, LeadAwayFromWhatIsTouched)
{
    std::vector<float> ranges_m(1, 0.3F);
    GuardScan scan;
    scan.ranges_m = ranges_m.data();
    scan.beams = 1;
    const auto ways = free_ways(scan, 0.6, 120, 4);
    EXPECT_EQ(ways[60], 0);
    EXPECT_EQ(ways[119], 4);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <guard_world.h>
#include <rtob/avoid/velocity_guard.h>
#include <rtob/core/enum_names.h>

#include <limits>

using namespace rtob;
using namespace rtob::test;
using Eigen::Vector2d;

namespace
{
/// The vehicle's middle at the origin; walls 2 m away on all sides, out of its clearance of 0.6 m.
Room square_room()
{
    return Room({{-2, -2, 2, -2}, {2, -2, 2, 2}, {2, 2, -2, 2}, {-2, 2, -2, -2}});
}

VelocityGuard guard_in_square(const GuardOptions& options = {})
{
    return guard_in(square_room(), {}, {}, options);
}

GuardDecision decide(VelocityGuard& guard, const Vector2d& wish, double time_s = 0.05)
{
    return guard.decide(time_s, wish, standing());
}
}  // namespace

TEST(VelocityGuard, GrantsASlowWish)
{
    auto guard = guard_in_square();
    const GuardDecision decision = decide(guard, {0.3, 0.1});
    EXPECT_EQ(decision.velocity_vehicle, Vector2d(0.3, 0.1));
    EXPECT_EQ(decision.reason, GuardReason::Free);
    EXPECT_EQ(decision.limiting_distance_m, 0);
}

// Straight at a wall: 2 - 0.6 m to stop in; v (0.25 + 0.1 + 0.25) + v^2 / (2 * 1.4) = 1.4 gives
// v = 1.31 m/s for a vehicle that starts from rest.
TEST(VelocityGuard, SlowsToWhatCanBeStopped)
{
    auto guard = guard_in_square();
    const GuardDecision decision = decide(guard, {1.9, 0});
    EXPECT_EQ(decision.reason, GuardReason::Slowed);
    EXPECT_NEAR(decision.velocity_vehicle.x(), 1.31, 0.02);  // a 128th of the wish is one step
    EXPECT_EQ(decision.velocity_vehicle.y(), 0);
    EXPECT_NEAR(decision.limiting_distance_m, 2, 0.01);
    EXPECT_NEAR(decision.limiting_bearing_rad, 0, 0.1);
}

TEST(VelocityGuard, StopsBeforeAWallAndLetsGoAway)
{
    auto guard = guard_in(square_room(), {1.395, 0, 0});
    EXPECT_EQ(decide(guard, {0.5, 0}).reason, GuardReason::Blocked);
    EXPECT_TRUE(decide(guard, {0.5, 0}).velocity_vehicle.isZero());
    EXPECT_EQ(decide(guard, {-0.5, 0}).velocity_vehicle, Vector2d(-0.5, 0));
}

TEST(VelocityGuard, LetsOutOfTheMarginButNotDeeperIn)
{
    auto guard = guard_in(square_room(), {1.5, 0, 0});  // 0.5 m from the wall
    EXPECT_TRUE(decide(guard, {0.2, 0}).velocity_vehicle.isZero());
    EXPECT_EQ(decide(guard, {-0.5, 0.1}).velocity_vehicle, Vector2d(-0.5, 0.1));
}

// Straight ahead, or beside the way: a stop may pass it by now, but it may also end before it.
TEST(VelocityGuard, StopsForWhatComesIntoViewTooLate)
{
    const VehicleMotion fast = flying(1.9, 0);  // 2.47 m to stop in
    for (const double left_m : {0.0, 0.2, -0.4})
    {
        VelocityGuard guard;
        static_cast<void>(guard.decide(0, {0, 0}, fast));
        const Room post({{1.2, left_m - 0.02, 1.2, left_m + 0.02}, {-3, -3, -3, 3}});
        const RoomScan seen(post, {}, 0);
        guard.observe(seen.scan, known_pose(0, {}));
        const GuardDecision decision = guard.decide(0.05, {1.9, 0}, fast);
        EXPECT_EQ(decision.reason, GuardReason::Blocked) << left_m;
        EXPECT_TRUE(decision.velocity_vehicle.isZero()) << left_m;
        const Vector2d seen_vehicle(1.2 - 0.05 * 1.9, left_m);
        EXPECT_NEAR(decision.limiting_distance_m, seen_vehicle.norm(), 0.03) << left_m;
        EXPECT_EQ(guard.decide(0.1, {-0.5, 0}, fast).velocity_vehicle, Vector2d(-0.5, 0)) << left_m;
    }
}

TEST(VelocityGuard, BendsAlongAWall)
{
    auto guard = guard_in(square_room(), {1.37, 0, 0});
    const Vector2d wish(0.3, 0.5);  // 31 degrees into the wall
    const GuardDecision decision = decide(guard, wish);
    EXPECT_EQ(decision.reason, GuardReason::Guided);
    EXPECT_GT(decision.bend_rad, 0.4);
    EXPECT_GT(decision.velocity_vehicle.y(), 0.3);
    EXPECT_LE(decision.velocity_vehicle.norm(), wish.norm());
}

TEST(VelocityGuard, GuidesThroughADoor)
{
    // 1.3 m wide, the vehicle needs 1.2 m; 20 cm off the middle.
    const Room door({{1, -3, 1, -0.65}, {1, 0.65, 1, 3}, {-3, -3, -3, 3}, {3, -3, 3, 3}});
    GuardOptions options;
    options.unknown = UnknownPolicy::Allow;
    auto guard = guard_in(door, {0, -0.2, 0}, {}, options);
    const GuardDecision decision = decide(guard, {1.5, 0});
    EXPECT_EQ(decision.reason, GuardReason::Guided);
    EXPECT_GT(decision.bend_rad, 0.1);
}

TEST(VelocityGuard, TakesTheTopSpeedForAnAbsurdWish)
{
    GuardOptions options;
    options.unknown = UnknownPolicy::Allow;
    auto guard = guard_in(Room({{-3, -1, -3, 1}}), {}, {}, options);
    const GuardDecision decision = decide(guard, {0, 100});
    EXPECT_EQ(decision.velocity_vehicle, Vector2d(0, 2));
    EXPECT_EQ(decision.reason, GuardReason::Slowed);
}

TEST(VelocityGuard, StopsWithoutAScan)
{
    VelocityGuard guard;
    EXPECT_EQ(decide(guard, {1, 0}).reason, GuardReason::NoData);
    EXPECT_TRUE(decide(guard, {1, 0}).velocity_vehicle.isZero());
}

TEST(VelocityGuard, StopsWhenTheSensorIsCovered)
{
    auto guard = guard_in_square();
    RoomScan covered(square_room(), {}, 0.1);
    std::fill(covered.ranges_m.begin(), covered.ranges_m.end(), 0.0F);
    guard.observe(covered.scan, known_pose(0.1, {}));
    EXPECT_EQ(decide(guard, {0.1, 0}, 0.15).reason, GuardReason::NoData);
    // A hand on the sensor: something is near, all around.
    RoomScan hand(square_room(), {}, 0.2);
    std::fill(hand.ranges_m.begin(), hand.ranges_m.end(), 0.16F);
    guard.observe(hand.scan, known_pose(0.2, {}));
    EXPECT_EQ(decide(guard, {0.1, 0}, 0.25).reason, GuardReason::Blocked);
}

TEST(VelocityGuard, StopsWhenTheDriverFreezes)
{
    auto guard = guard_in_square();
    for (double time_s = 0.1; time_s < 0.5; time_s += 0.1)
        EXPECT_EQ(decide(guard, {0.3, 0}, time_s).reason, GuardReason::Free);
    EXPECT_EQ(decide(guard, {0.3, 0}, 0.55).reason, GuardReason::Stale);
    EXPECT_TRUE(decide(guard, {0.3, 0}, 0.6).velocity_vehicle.isZero());
}

TEST(VelocityGuard, PassesOverScansFromThePast)
{
    auto guard = guard_in_square();
    static_cast<void>(decide(guard, {0, 0}, 0.3));
    const RoomScan old(square_room(), {}, -0.1);
    guard.observe(old.scan, known_pose(-0.1, {}));
    EXPECT_EQ(decide(guard, {0.3, 0}, 0.55).reason, GuardReason::Stale);
}

TEST(VelocityGuard, StopsWhenTheClockRunsBack)
{
    auto guard = guard_in_square();
    static_cast<void>(decide(guard, {0, 0}, 0.3));
    EXPECT_EQ(decide(guard, {0.3, 0}, 0.2).reason, GuardReason::NoData);
    const RoomScan seen(square_room(), {}, 0.25);
    static_cast<void>(decide(guard, {0, 0}, 0.26));
    guard.observe(seen.scan, known_pose(0.25, {}));
    EXPECT_EQ(decide(guard, {0.3, 0}, 0.3).reason, GuardReason::Free);
}

TEST(VelocityGuard, StopsForWhatIsNoNumber)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    auto guard = guard_in_square();
    EXPECT_EQ(guard.decide(0.05, {nan, 0}, standing()).reason, GuardReason::NoData);
    EXPECT_EQ(guard.decide(0.06, {0.3, 0}, flying(nan, 0)).reason, GuardReason::NoData);
    EXPECT_EQ(guard.decide(0.07, {0.3, 0}, flying(1e9, 0)).reason, GuardReason::NoData);
    EXPECT_EQ(guard.decide(nan, {0.3, 0}, standing()).reason, GuardReason::NoData);
    VehicleMotion spinning;
    spinning.yaw_rate_radps = nan;
    EXPECT_EQ(guard.decide(0.08, {0.3, 0}, spinning).reason, GuardReason::NoData);
    EXPECT_EQ(guard.decide(0.09, {0.3, 0}, standing()).reason, GuardReason::Free);
}

TEST(VelocityGuard, PassesOverBrokenScans)
{
    auto guard = guard_in_square();
    RoomScan seen(square_room(), {}, 0.1);
    const auto with = [&](auto&& damage)
    {
        GuardScan scan = seen.scan;
        damage(scan);
        guard.observe(scan, known_pose(0.1, {}));
        EXPECT_EQ(decide(guard, {0.3, 0}, 0.2).reason, GuardReason::Free);
    };
    with([](GuardScan& scan) { scan.ranges_m = nullptr; });
    with([](GuardScan& scan) { scan.beams = 0; });
    with([](GuardScan& scan) { scan.stamp_s = NAN; });
    with([](GuardScan& scan) { scan.sweep_s = 1e9; });
    with([](GuardScan& scan) { scan.max_range_m = -1; });
    with([](GuardScan& scan) { scan.pose_vehicle_laser.x = NAN; });
}

TEST(VelocityGuard, RemembersWhatIsOutOfView)
{
    const Room post({{1.2, -0.1, 1.2, 0.1}, {-3, -3, -3, 3}});
    GuardOptions options;
    options.unknown = UnknownPolicy::Allow;
    auto guard = guard_in(post, {}, {}, options);
    const RoomScan blind(Room({{-3, -3, -3, 3}}), {}, 0.1, false);
    guard.observe(blind.scan, known_pose(0.1, {}));
    EXPECT_GT(guard.remembered_map().size, 0u);
    EXPECT_EQ(decide(guard, {1.5, 0}, 0.15).reason, GuardReason::Guided);
    // And no more, once LOST: then it flies by the laser alone, slowly.
    const RoomScan again(Room({{-3, -3, -3, 3}}), {}, 0.2, false);
    guard.observe(again.scan, MapPose());
    EXPECT_EQ(guard.remembered_map().size, 0u);
    const GuardDecision lost = decide(guard, {1.5, 0}, 0.25);
    EXPECT_EQ(lost.reason, GuardReason::Lost);
    EXPECT_EQ(lost.velocity_vehicle, Vector2d(0.3, 0));
}

TEST(VelocityGuard, DropsItsMemoryWhenThePoseJumps)
{
    const Room post({{1.2, -0.1, 1.2, 0.1}, {-3, -3, -3, 3}});
    auto guard = guard_in(post, {});
    const RoomScan blind(Room({{-3, -3, -3, 3}}), {}, 0.1, false);
    guard.observe(blind.scan, known_pose(0.1, {5, 0, 0}));
    EXPECT_EQ(guard.remembered_map().size, 0u);
}

TEST(VelocityGuard, IsLostWithAPoseThatIsNoNumber)
{
    auto guard = guard_in_square();
    const RoomScan seen(square_room(), {}, 0.1);
    guard.observe(seen.scan, known_pose(0.1, {NAN, 0, 0}));
    EXPECT_EQ(decide(guard, {1, 0}, 0.15).reason, GuardReason::Lost);
}

TEST(VelocityGuard, ThinksOfTheUnknownAsToldTo)
{
    const Room half({{-1, -4, -1, 4}});  // nothing returns from ahead
    const auto decided = [&](UnknownPolicy policy, const Vector2d& wish)
    {
        GuardOptions options;
        options.unknown = policy;
        VelocityGuard guard({}, options);
        static_cast<void>(guard.decide(0, {0, 0}, standing()));
        const RoomScan seen(half, {}, 0, false);
        guard.observe(seen.scan, known_pose(0, {}));
        return decide(guard, wish);
    };
    EXPECT_EQ(decided(UnknownPolicy::Block, {1, 0}).reason, GuardReason::NoData);
    EXPECT_TRUE(decided(UnknownPolicy::Block, {1, 0}).velocity_vehicle.isZero());
    EXPECT_EQ(decided(UnknownPolicy::Creep, {1, 0}).velocity_vehicle, Vector2d(0.25, 0));
    EXPECT_EQ(decided(UnknownPolicy::Creep, {1, 0}).reason, GuardReason::NoData);
    EXPECT_EQ(decided(UnknownPolicy::Allow, {1, 0}).velocity_vehicle, Vector2d(1, 0));
    EXPECT_EQ(decided(UnknownPolicy::Block, {-0.1, 0}).velocity_vehicle, Vector2d(-0.1, 0));
}

// 1 m/s towards the wall for 0.3 s after the scan: it is that much nearer than it was seen.
TEST(VelocityGuard, MovesTheScanByTheMotionSince)
{
    VelocityGuard guard;
    static_cast<void>(guard.decide(0, {0, 0}, flying(1, 0)));
    const RoomScan seen(square_room(), {}, 0);
    guard.observe(seen.scan, known_pose(0, {}));
    for (double time_s = 0.05; time_s < 0.31; time_s += 0.05)
    {
        const GuardDecision decision = guard.decide(time_s, {1.9, 0}, flying(1, 0));
        EXPECT_NEAR(decision.limiting_distance_m, 2 - time_s, 0.01);
    }
}

TEST(VelocityGuard, RefusesOptionsOutOfRange)
{
    VehicleLimits limits;
    limits.radius_m = 0;
    EXPECT_THROW(VelocityGuard{limits}, std::invalid_argument);
    GuardOptions options;
    options.guide_deg = 90;
    EXPECT_THROW(VelocityGuard(VehicleLimits(), options), std::invalid_argument);
}

TEST(GuardReason, NamesAreThoseOfTheDocumentation)
{
    EXPECT_EQ(name_of(GuardReason::NoData), "NO_DATA");
    EXPECT_EQ(parse_enum<GuardReason>("BLOCKED"), GuardReason::Blocked);
}

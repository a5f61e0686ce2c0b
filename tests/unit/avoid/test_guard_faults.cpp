// SPDX-License-Identifier: BSD-3-Clause
// Whatever comes in, the answer is a stop or a lower speed, with its reason, within 20 ms.
#include <gtest/gtest.h>
#include <guard_world.h>
#include <rtob/core/enum_names.h>
#include <rtob/core/processor_time.h>

#include <functional>
#include <limits>

using namespace rtob;
using namespace rtob::test;
using Eigen::Vector2d;

namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const Vector2d wish(0.3, 0);

Room square_room()
{
    return Room({{-2, -2, 2, -2}, {2, -2, 2, 2}, {2, 2, -2, 2}, {-2, 2, -2, -2}});
}

/// What goes wrong, and what the guard says then.
struct Fault
{
    const char* name;
    GuardReason reason;
    double most_mps;  ///< of the answer
    std::function<GuardDecision(VelocityGuard&)> happens;
};

GuardDecision with_ranges(VelocityGuard& guard, float range_m)
{
    RoomScan scan(square_room(), {}, 0.1);
    std::fill(scan.ranges_m.begin(), scan.ranges_m.end(), range_m);
    guard.observe(scan.scan, known_pose(0.1, {}));
    return guard.decide(0.15, wish, standing());
}

GuardDecision at_pose(VelocityGuard& guard, const MapPose& pose, const Vector2d& wished)
{
    const RoomScan scan(square_room(), {}, 0.1);
    guard.observe(scan.scan, pose);
    return guard.decide(0.15, wished, standing());
}

GuardDecision after_silence(VelocityGuard& guard, double until_s)
{
    for (double time_s = 0.1; time_s < until_s; time_s += 0.1)
        static_cast<void>(guard.decide(time_s, wish, standing()));
    return guard.decide(until_s, wish, standing());
}

GuardDecision with_old_scan(VelocityGuard& guard)
{
    static_cast<void>(guard.decide(0.4, wish, standing()));
    const RoomScan past(square_room(), {}, -0.2);
    guard.observe(past.scan, known_pose(-0.2, {}));
    return guard.decide(0.6, wish, standing());
}

GuardDecision with_future_scan(VelocityGuard& guard)
{
    const RoomScan future(square_room(), {}, 0.9);
    guard.observe(future.scan, known_pose(0.9, {}));
    return guard.decide(0.15, wish, standing());
}

GuardDecision without_any_scan(VelocityGuard&)
{
    VelocityGuard guard;
    return guard.decide(0, wish, standing());
}

const std::vector<Fault>& all_faults()
{
    using R = GuardReason;
    static const std::vector<Fault> faults{
        {"nothing returns", R::NoData, 0, [](auto& g) { return with_ranges(g, 0); }},
        {"NaN ranges", R::NoData, 0, [](auto& g) { return with_ranges(g, NAN); }},
        {"a hand on the sensor", R::Blocked, 0, [](auto& g) { return with_ranges(g, 0.16F); }},
        {"a frozen driver", R::Stale, 0, [](auto& g) { return after_silence(g, 0.6); }},
        {"scans from the past", R::Stale, 0, with_old_scan},
        {"scans from the future", R::Stale, 0, with_future_scan},
        {"no scan yet", R::NoData, 0, without_any_scan},
        {"NaN velocity", R::NoData, 0,
         [](auto& g) { return g.decide(0.05, wish, flying(kNan, 0)); }},
        {"absurd velocity", R::NoData, 0,
         [](auto& g) { return g.decide(0.05, wish, flying(1e9, 0)); }},
        {"NaN wish", R::NoData, 0,
         [](auto& g) {
             return g.decide(0.05, {kNan, 0}, standing());
         }},
        {"NaN time", R::NoData, 0, [](auto& g) { return g.decide(kNan, wish, standing()); }},
        {"a LOST pose", R::Lost, 0.3,
         [](auto& g) {
             return at_pose(g, {}, {1, 0});
         }},
        {"a NaN pose", R::Lost, 0.3,
         [](auto& g) {
             return at_pose(g, known_pose(0.1, {kNan, 0, 0}), {1, 0});
         }},
        {"a wish of 100 m/s", R::Slowed, 1.35,
         [](auto& g) {
             return g.decide(0.05, {100, 0}, standing());
         }},
        {"an endless wish", R::NoData, 0, [](auto& g) {
             return g.decide(0.05, {std::numeric_limits<double>::infinity(), 0}, standing());
         }}};
    return faults;
}
}  // namespace

TEST(GuardFaults, EachHasItsReasonAndStopsOrSlows)
{
    for (const Fault& fault : all_faults())
    {
        VelocityGuard guard = guard_in(square_room(), {});
        const double began_s = thread_processor_time_s();
        const GuardDecision decision = fault.happens(guard);
        const double took_s = thread_processor_time_s() - began_s;
        EXPECT_EQ(name_of(decision.reason), name_of(fault.reason)) << fault.name;
        EXPECT_LE(decision.velocity_vehicle.norm(), fault.most_mps) << fault.name;
        EXPECT_LT(took_s, 0.020) << fault.name;
    }
}

// No memory yet and nothing within reach: the scan alone decides.
TEST(GuardFaults, AnEmptyMapNeedsNoMemory)
{
    VelocityGuard guard = guard_in(square_room(), {});
    EXPECT_EQ(guard.remembered_map().size, 0u);
    EXPECT_EQ(guard.decide(0.05, wish, standing()).reason, GuardReason::Free);
    EXPECT_EQ(guard.decide(0.06, {5, 0}, standing()).reason, GuardReason::Slowed);
}

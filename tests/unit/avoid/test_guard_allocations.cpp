// SPDX-License-Identifier: BSD-3-Clause
#include <allocation_count.h>
#include <gtest/gtest.h>
#include <guard_world.h>

using namespace rtob;
using namespace rtob::test;

TEST(VelocityGuardAllocations, NoneOnceAScanWasSeen)
{
    if (RTOB_SANITIZED) GTEST_SKIP() << "the sanitizers count memory themselves";
    const Room room = room_4x3();
    auto guard = guard_in(room, {1, 1, 0});
    int counted = 0;
    for (int i = 1; i < 100; ++i)
    {
        const double time_s = 0.1 * i;
        RoomScan seen(room, {1, 1, 0.05 * i}, time_s);
        for (std::size_t beam = 0; beam < 40; ++beam) seen.ranges_m[beam] = 0;  // to be remembered
        VehicleMotion turning;
        turning.yaw_rate_radps = 0.5;
        AllocationCount count;
        static_cast<void>(guard.decide(time_s, {2, 1}, turning));
        guard.observe(seen.scan, known_pose(time_s, {1, 1, 0.05 * i}));
        counted += count.soFar();
    }
    EXPECT_EQ(counted, 0);
    EXPECT_GT(guard.remembered_map().size, 0u);
}

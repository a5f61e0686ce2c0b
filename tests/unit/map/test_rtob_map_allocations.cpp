// SPDX-License-Identifier: BSD-3-Clause
#include <allocation_count.h>
#include <gtest/gtest.h>
#include <rtob/map/rtob_map.h>

#include "room.h"

using rtob::Pose2;
using rtob::Reference;
using rtob::RtobMap;

// Not seen here: MRPT's own allocator, which holds x, y and z; their capacity is looked at instead.
TEST(RtobMap, AllocatesNothingForAScanUntilABlockIsFull)
{
    if (RTOB_SANITIZED) GTEST_SKIP() << "sanitizers replace operator new themselves";
    RtobMap map;
    Reference reference;
    const auto scan = rtob::test::room_4x3().scan_vehicle({1.5, 1, 0});
    const auto process = [&](int k)
    {
        const Pose2 pose{1.5 + 0.001 * k, 1, 0};
        const double now_s = map.tick(0.1 * k);
        map.draw(pose, reference);
        map.insertScan(now_s, pose, scan.view());
    };
    for (int k = 0; k < 20; ++k) process(k);
    const auto* first_x = map.points().x;
    const rtob::test::AllocationCount count;
    for (int k = 20; k < 700; ++k) process(k);  // 700 scans of 360 points: one block
    EXPECT_EQ(count.soFar(), 0);
    EXPECT_EQ(map.points().x, first_x);
}

// SPDX-License-Identifier: BSD-3-Clause
// A flight without an end, in a map under a cap.
#include <gmock/gmock.h>

#include <vector>

#include "endure/endurance.h"
#include "sanitized.h"

namespace rtob
{
TEST(Endurance, UnderACapMapAndMemoryStayWhereTheyAre)
{
    constexpr std::size_t cap = 20'000;  // reached within 300 scans
    EnduranceJob job;
    job.world = RTOB_SOURCE_DIR "/share/worlds/room.yaml";
    job.scans = 1200;
    job.every_scans = 300;
    job.slam.map.max_points = static_cast<int>(cap);
    std::vector<EnduranceBlock> blocks;
    endure(job, [&](const EnduranceBlock& block) { blocks.push_back(block); });
    ASSERT_EQ(blocks.size(), 4U);
    for (const EnduranceBlock& block : blocks)
    {
        EXPECT_LE(block.map_points, cap) << block.scans;
        EXPECT_GT(block.map_points, cap / 2) << block.scans;
        EXPECT_LT(block.error_max_m, 0.1) << block.scans;
    }
    if (RTOB_SANITIZED) GTEST_SKIP() << "sanitizers keep what was given back";
    EXPECT_LT(blocks[3].memory_mb, blocks[1].memory_mb + 2);
}

TEST(Endurance, ALineTellsOfHours)
{
    EnduranceBlock block;
    block.scans = 72'000;
    block.memory_mb = 101.5;
    EXPECT_THAT(endurance_line(block), testing::ContainsRegex("72000 +2.00 .* 101.5 "));
}
}  // namespace rtob

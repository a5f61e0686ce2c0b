// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/avoid/command_log.h>

using namespace rtob;
using Eigen::Vector2d;

namespace
{
std::size_t acting_at(const CommandLog& log, double now_s)
{
    std::array<Vector2d, CommandLog::kMaxActing> acting;
    return log.acting(now_s, acting);
}
}  // namespace

TEST(CommandLog, HoldsTheLastLatencyAndOneBefore)
{
    CommandLog log(0.25);
    EXPECT_EQ(acting_at(log, 0), 0u);
    for (int i = 0; i < 10; ++i) log.add(0.1 * i, {0.1 * i, 0});
    std::array<Vector2d, CommandLog::kMaxActing> acting;
    ASSERT_EQ(log.acting(0.96, acting), 3u);  // those of 0.9 and 0.8 s, and of 0.7 s before
    EXPECT_DOUBLE_EQ(acting[2].x(), 0.7);
    EXPECT_EQ(acting_at(log, 100), 1u);
}

TEST(CommandLog, PutsABoxAroundMany)
{
    CommandLog log(10);
    for (int i = 0; i < 100; ++i) log.add(0.01 * i, {i % 7, -(i % 5)});
    std::array<Vector2d, CommandLog::kMaxActing> acting;
    ASSERT_EQ(log.acting(1, acting), 4u);
    EXPECT_EQ(acting[0], Vector2d(0, -4));
    EXPECT_EQ(acting[2], Vector2d(6, 0));
}

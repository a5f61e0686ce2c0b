// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/drivers/time_sync.h>

namespace rtob
{
namespace
{
constexpr std::int64_t ms = 1'000'000, second = 1000 * ms;

/// The other clock runs 40 s behind ours.
void ask(TimeSync& sync, std::int64_t now, std::int64_t there, std::int64_t back)
{
    sync.answered(now, now + there - 40 * second, now + there + back);
}

TEST(TimeSync, FindsTheOffset)
{
    TimeSync sync;
    EXPECT_FALSE(sync.toOurs(0));
    for (int i = 0; i < 10; ++i) ask(sync, 100 * second + i * second, 3 * ms, 3 * ms);
    ASSERT_TRUE(sync.toOurs(60 * second));
    EXPECT_NEAR(100.0, *sync.toOurs(60 * second), 1e-6);
    EXPECT_NEAR(0.006, sync.roundTrip_s(), 1e-9);
}

TEST(TimeSync, RefusesSlowAnswers)
{
    TimeSync sync;
    for (int i = 0; i < 10; ++i) ask(sync, 100 * second + i * second, 1 * ms, 1 * ms);
    for (int i = 0; i < 10; ++i) ask(sync, 120 * second + i * second, 80 * ms, 1 * ms);
    EXPECT_EQ(10u, sync.refused());
    EXPECT_NEAR(100.0, *sync.toOurs(60 * second), 1e-6);
}

TEST(TimeSync, BelievesARestartOnlyAfterAWhile)
{
    TimeSync sync;
    for (int i = 0; i < 10; ++i) ask(sync, 100 * second + i * second, ms, ms);
    const auto restarted = [&](int i) {
        sync.answered(
            200 * second + i * second, i * second + ms, 200 * second + i * second + 2 * ms);
    };
    for (int i = 0; i < 4; ++i) restarted(i);
    EXPECT_NEAR(100.0, *sync.toOurs(60 * second), 1e-6);
    for (int i = 4; i < 12; ++i) restarted(i);
    EXPECT_NEAR(200.0, *sync.toOurs(0), 1e-6);
}
}  // namespace
}  // namespace rtob

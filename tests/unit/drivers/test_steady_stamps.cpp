// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/drivers/steady_stamps.h>

#include <algorithm>

using rtob::SteadyStamps;

namespace
{
constexpr double kPeriod_s = 0.01;

/// So many packets that are not late, the first one at begin_s; the last one's time.
double steady(SteadyStamps& stamps, double begin_s, int packets)
{
    double sent_s = 0;
    for (int i = 0; i < packets; ++i) sent_s = stamps.sent(begin_s + i * kPeriod_s);
    return sent_s;
}
}  // namespace

TEST(SteadyStamps, PassTimesWithoutAPeriod)
{
    SteadyStamps stamps;
    EXPECT_EQ(stamps.sent(3), 3);
    EXPECT_EQ(stamps.sent(5), 5);
}

TEST(SteadyStamps, TakeOffWhatIsReadLate)
{
    SteadyStamps stamps(kPeriod_s);
    EXPECT_NEAR(steady(stamps, 100, 20), 100.19, 1e-9);
    for (int i = 20; i < 40; ++i)  // all of them at once
        EXPECT_NEAR(stamps.sent(100.4), 100 + i * kPeriod_s, 1e-9);
    EXPECT_NEAR(stamps.sent(100.4), 100.4, 1e-9);
}

// A delay longer than the memory: the times are late then, but in order.
TEST(SteadyStamps, NeverStepBack)
{
    SteadyStamps stamps(kPeriod_s);
    double last_s = steady(stamps, 100, 20);
    for (int i = 20; i < 200; ++i)
    {
        const double sent_s = stamps.sent(std::max(101.0, 100 + i * kPeriod_s));
        EXPECT_GE(sent_s, last_s);
        last_s = sent_s;
    }
    EXPECT_NEAR(last_s, 101.99, 1e-9);
}

TEST(SteadyStamps, FollowADeviceThatIsALittleSlower)
{
    SteadyStamps stamps(kPeriod_s);
    for (int i = 0; i < 1000; ++i)
    {
        const double truth_s = 100 + i * 1.01 * kPeriod_s;
        EXPECT_NEAR(stamps.sent(truth_s), truth_s, 5.2e-3);
    }
}

TEST(SteadyStamps, BeginAnewAfterSilenceAndLoss)
{
    SteadyStamps stamps(kPeriod_s);
    static_cast<void>(steady(stamps, 100, 20));
    EXPECT_NEAR(stamps.sent(102), 102, 1e-9);
    EXPECT_NEAR(stamps.sent(102.05), 102.01, 1e-9);
    stamps.forget();
    EXPECT_NEAR(stamps.sent(102.1), 102.1, 1e-9);
}

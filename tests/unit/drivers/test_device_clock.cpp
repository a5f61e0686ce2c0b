// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/drivers/device_clock.h>

using rtob::DeviceClock;

namespace
{
constexpr double kPeriod_s = 0.025, kMemory_s = 10, kLongestDelay_s = 10;

/// So many packets, each arriving when it was sent; the computer's clock says more by this.
void punctual(DeviceClock& clock, double first_s, int packets, double ahead_s)
{
    for (int i = 0; i < packets; ++i)
    {
        const double device_s = first_s + i * kPeriod_s;
        EXPECT_NEAR(clock.sent(device_s, device_s + ahead_s), device_s + ahead_s, 1e-9);
    }
}
}  // namespace

TEST(DeviceClock, TakesOffWhatArrivesLate)
{
    DeviceClock clock(kMemory_s, kLongestDelay_s);
    punctual(clock, 5, 10, 100);
    EXPECT_NEAR(clock.sent(6, 108.3), 106, 1e-9);
    EXPECT_NEAR(clock.sent(6.025, 106.5), 106.025, 1e-9);
}

// A driver that set its clock by a late packet stamps all others late: after they arrived.
TEST(DeviceClock, LetsNothingBeSentAfterItArrived)
{
    DeviceClock clock(kMemory_s, kLongestDelay_s);
    EXPECT_NEAR(clock.sent(102, 102), 102, 1e-9);
    EXPECT_NEAR(clock.sent(102.025, 102.005), 102.005, 1e-9);  // what waited is read at once
    EXPECT_NEAR(clock.sent(104, 102), 102.005, 1e-9);          // and never before the last one
    EXPECT_NEAR(clock.sent(104.025, 102.025), 102.025, 1e-9);
    EXPECT_NEAR(clock.sent(104.05, 102.09), 102.05, 1e-9);
}

TEST(DeviceClock, FollowsAClockThatRunsSlow)
{
    constexpr double slow = 1e-4;  // ten times a quartz
    DeviceClock clock(kMemory_s, kLongestDelay_s);
    for (int i = 0; i < 40000; ++i)
    {
        const double truth_s = 100 + i * kPeriod_s;
        EXPECT_NEAR(clock.sent((1 - slow) * i * kPeriod_s, truth_s), truth_s, 1.1e-3);
    }
}

TEST(DeviceClock, BeginsAnewWhenTheClockWasSet)
{
    DeviceClock clock(kMemory_s, kLongestDelay_s);
    punctual(clock, 5, 10, 100);
    punctual(clock, 4e6, 10, 110 - 4e6);  // ahead
    punctual(clock, 20, 10, 95);          // back
    punctual(clock, 19, 10, 97);          // back by less than a delay may be
    clock.forget();
    punctual(clock, 15, 10, 105);
}

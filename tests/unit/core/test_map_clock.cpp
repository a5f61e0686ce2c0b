// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/map_clock.h>

#include <limits>

namespace
{
constexpr double kStart_s = 1.6e9;  // a UNIX time
constexpr double kDay_s = 86400;
}  // namespace

TEST(MapClock, StartsAtZeroAndFollowsTheStamps)
{
    rtob::MapClock clock;
    EXPECT_EQ(clock.now(), 0);
    EXPECT_EQ(clock.advance(kStart_s), 0);
    EXPECT_DOUBLE_EQ(clock.advance(kStart_s + 0.25), 0.25);
    EXPECT_DOUBLE_EQ(clock.advance(kStart_s + 9.25), 9.25);
    EXPECT_DOUBLE_EQ(clock.now(), 9.25);
    EXPECT_EQ(clock.anomalies().steps_back, 0u);
    EXPECT_EQ(clock.anomalies().repeats, 0u);
    EXPECT_EQ(clock.anomalies().jumps, 0u);
    EXPECT_EQ(clock.anomalies().invalid, 0u);
}

TEST(MapClock, StandsStillWhileStampsStepBackOrRepeat)
{
    rtob::MapClock clock;
    clock.advance(kStart_s);
    clock.advance(kStart_s + 1);
    EXPECT_EQ(clock.advance(kStart_s + 0.5), 1);  // back
    EXPECT_EQ(clock.advance(kStart_s + 0.5), 1);  // repeat
    // The step counts from the stamp before, also from one that ran back.
    EXPECT_EQ(clock.advance(kStart_s + 0.75), 1.25);
    EXPECT_EQ(clock.anomalies().steps_back, 1u);
    EXPECT_EQ(clock.anomalies().repeats, 1u);
}

TEST(MapClock, CutsAJumpByADayAndTheWayBack)
{
    rtob::MapClock clock(5.0);
    clock.advance(kStart_s);
    EXPECT_EQ(clock.advance(kStart_s + kDay_s), 5);
    EXPECT_EQ(clock.advance(kStart_s + 1), 5);
    EXPECT_EQ(clock.advance(kStart_s + 2), 6);
    EXPECT_EQ(clock.anomalies().jumps, 1u);
    EXPECT_EQ(clock.anomalies().steps_back, 1u);
}

TEST(MapClock, AStepOfExactlyTheLargestIsNoJump)
{
    rtob::MapClock clock(5.0);
    clock.advance(kStart_s);
    EXPECT_EQ(clock.advance(kStart_s + 5), 5);
    EXPECT_EQ(clock.anomalies().jumps, 0u);
}

TEST(MapClock, CountsStampsThatAreNoNumbersAndForgetsThem)
{
    rtob::MapClock clock;
    EXPECT_EQ(clock.advance(std::numeric_limits<double>::quiet_NaN()), 0);
    clock.advance(kStart_s);
    EXPECT_EQ(clock.advance(std::numeric_limits<double>::quiet_NaN()), 0);
    EXPECT_EQ(clock.advance(std::numeric_limits<double>::infinity()), 0);
    EXPECT_EQ(clock.advance(kStart_s + 1), 1);
    EXPECT_EQ(clock.anomalies().invalid, 3u);
    EXPECT_EQ(clock.anomalies().jumps, 0u);
}

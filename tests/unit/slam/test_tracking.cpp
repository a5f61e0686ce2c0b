// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/tracking.h>

#include <stdexcept>

using rtob::FitVerdict;
using rtob::TrackingState;
using rtob::TrackingStateMachine;

namespace
{
constexpr auto good = FitVerdict::Good, new_ground = FitVerdict::NewGround, weak = FitVerdict::Weak,
               none = FitVerdict::None;

TrackingStateMachine started(int lost_after, int confirm_after)
{
    TrackingStateMachine machine({lost_after, confirm_after});
    machine.start();
    return machine;
}

TrackingStateMachine lost()
{
    auto machine = started(1, 3);
    machine.next(weak);
    return machine;
}
}  // namespace

TEST(Tracking, BeginsWithInitUntilStarted)
{
    TrackingStateMachine machine;
    EXPECT_EQ(machine.state(), TrackingState::Init);
    machine.start();
    EXPECT_EQ(machine.state(), TrackingState::Tracking);
    EXPECT_FALSE(machine.isLost());
}

TEST(Tracking, GoesOnWithGoodFitsAndNewGround)
{
    auto machine = started(2, 1);
    for (const auto verdict : {good, new_ground, new_ground, new_ground, good})
        EXPECT_EQ(machine.next(verdict), TrackingState::Tracking);
}

TEST(Tracking, IsDegradedByWeakFitsAndRecoversAtOnce)
{
    for (const auto bad : {weak, none})
    {
        auto machine = started(3, 2);
        EXPECT_EQ(machine.next(bad), TrackingState::Degraded);
        EXPECT_EQ(machine.next(bad), TrackingState::Degraded);
        EXPECT_EQ(machine.next(good), TrackingState::Tracking);
        // The count of weak scans begins anew.
        EXPECT_EQ(machine.next(bad), TrackingState::Degraded);
        EXPECT_EQ(machine.next(bad), TrackingState::Degraded);
        EXPECT_EQ(machine.next(bad), TrackingState::Lost);
        EXPECT_TRUE(machine.isLost());
    }
}

TEST(Tracking, IsFoundAgainOnlyAfterSeveralGoodFitsInARow)
{
    auto machine = lost();
    EXPECT_EQ(machine.next(good), TrackingState::Relocalising);
    EXPECT_TRUE(machine.isLost());
    EXPECT_EQ(machine.next(good), TrackingState::Relocalising);
    EXPECT_EQ(machine.next(weak), TrackingState::Lost);  // not confirmed
    EXPECT_EQ(machine.next(good), TrackingState::Relocalising);
    EXPECT_EQ(machine.next(good), TrackingState::Relocalising);
    EXPECT_EQ(machine.next(good), TrackingState::Tracking);
    EXPECT_FALSE(machine.isLost());
}

TEST(Tracking, NewGroundSaysNothingToOneWhoIsLost)
{
    auto machine = lost();
    for (int k = 0; k < 10; ++k) EXPECT_EQ(machine.next(new_ground), TrackingState::Lost);
    machine.next(good);
    EXPECT_EQ(machine.next(new_ground), TrackingState::Lost);
}

TEST(TrackingOptions, RefusesCountsBelowOne)
{
    EXPECT_THROW(TrackingStateMachine({0, 3}), std::invalid_argument);
    EXPECT_THROW(TrackingStateMachine({10, 0}), std::invalid_argument);
}

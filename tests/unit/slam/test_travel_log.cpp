// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/travel_log.h>

using rtob::TravelLog;

TEST(TravelLog, IsEmptyAtFirst)
{
    const TravelLog travel;
    EXPECT_EQ(travel.path(), 0);
    EXPECT_EQ(travel.scansBefore(5), 0u);
}

TEST(TravelLog, CountsScansFromBeforeTheLastMetres)
{
    TravelLog travel;
    for (int i = 0; i <= 10; ++i) travel.inserted({0, 2.0 * i, 0});  // at 0, 2 ... 20 m
    EXPECT_NEAR(travel.path(), 20, 1e-5);
    EXPECT_EQ(travel.scansBefore(5), 8u);  // those at 0 ... 14 m
    EXPECT_EQ(travel.scansBefore(100), 0u);
    EXPECT_EQ(travel.scansBefore(0.5), 10u);  // all but the last
}

TEST(TravelLog, StandingStillAddsNoTravel)
{
    TravelLog travel;
    for (int i = 0; i < 1000; ++i) travel.inserted({3, 4, 0.1 * i});
    EXPECT_EQ(travel.path(), 0);
    EXPECT_EQ(travel.scansBefore(0.1), 0u);
}

TEST(TravelLog, TheFirstPoseIsNoTravel)
{
    TravelLog travel;
    travel.inserted({100, 100, 0});
    EXPECT_EQ(travel.path(), 0);
}

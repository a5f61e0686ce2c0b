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

TEST(TravelLog, KnowsTheTravelUpToEachScan)
{
    TravelLog travel;
    for (int i = 0; i <= 4; ++i) travel.inserted({0, 2.0 * i, 0});
    for (std::size_t scan = 0; scan <= 4; ++scan)
        EXPECT_NEAR(travel.pathAt(scan), 2.0 * static_cast<double>(scan), 1e-5);
}

TEST(TravelLog, TheNextStepSetsOffFromWhereTheNewestScanWasMoved)
{
    TravelLog travel;
    travel.inserted({0, 0, 0});
    travel.inserted({1, 0, 0});
    travel.moved({1, 100, 0});
    travel.inserted({2, 100, 0});
    EXPECT_NEAR(travel.path(), 2, 1e-5);
}

TEST(TravelLog, TravelCountsThoughItsScansAreForgotten)
{
    TravelLog travel;
    std::vector<char> keep;
    for (int i = 0; i <= 10; ++i)
    {
        travel.inserted({2.0 * i, 0, 0});
        keep.push_back(i % 2 == 0);
    }
    travel.keepOnly(keep);  // those at 0, 4 ... 20 m
    EXPECT_NEAR(travel.path(), 20, 1e-5);
    EXPECT_EQ(travel.scansBefore(5), 4u);
    travel.inserted({22, 0, 0});
    EXPECT_NEAR(travel.path(), 22, 1e-5);
}

/// A float would tell no centimetres any more.
TEST(TravelLog, SmallStepsCountAfterAThousandKilometres)
{
    TravelLog travel;
    double x = 0;
    travel.inserted({x, 0, 0});
    for (int i = 0; i < 40; ++i)
    {
        travel.inserted({x += 30'000, 0, 0});
        travel.keepOnly({0, 1});
    }
    const double before_m = travel.path();
    for (int i = 0; i < 100; ++i) travel.inserted({x += 0.02, 0, 0});
    EXPECT_NEAR(travel.path() - before_m, 2.0, 0.2);
}

TEST(TravelLog, ForgetsTheWayToScansThatAreTakenBack)
{
    TravelLog travel;
    for (int i = 0; i < 6; ++i) travel.inserted({2.0 * i, 0, 0});
    travel.keepOnly({1, 1, 1, 0, 0, 0});
    EXPECT_NEAR(travel.path(), 4, 1e-6);
    EXPECT_EQ(travel.scansBefore(0.5), 2u);
}

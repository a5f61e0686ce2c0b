// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/slam/slam.h>

#include "house.h"
#include "near_pose.h"

namespace
{
using namespace rtob;
using test::IsNearPose;

/// A map of the first laps.
Slam after_scans(int count)
{
    Slam slam;
    for (int k = 0; k < count; ++k) slam.process(test::scan_in_house(k));
    return slam;
}
}  // namespace

TEST(SlamContinue, TracksAndWritesOnInAnotherRunsMap)
{
    const Slam first = after_scans(100);
    Slam second;
    second.continueIn(first.map(), first.pose());
    EXPECT_EQ(second.state(), TrackingState::Tracking);
    const std::size_t scans = second.map().scans().size();
    for (int k = 100; k < 160; ++k)
    {
        const ScanReport& report = second.process(test::scan_in_house(k));
        ASSERT_EQ(report.state, TrackingState::Tracking) << k;
        ASSERT_THAT(test::pose_in_house_map(k), IsNearPose(report.pose_map_vehicle, 0.05, 0.02))
            << k;
    }
    EXPECT_GT(second.map().scans().size(), scans);
    EXPECT_GT(second.map().scans().time(scans), first.map().clock().now());
}

TEST(SlamContinue, TheNewRunsOptionsHoldInTheMap)
{
    const Slam first = after_scans(3);
    SlamOptions options;
    options.density.density = Density::Window;
    options.seed = 9;
    Slam second(options);
    second.continueIn(first.map(), first.pose());
    EXPECT_EQ(second.map().options().density.density, Density::Window);
    EXPECT_EQ(second.map().options().seed, 9U);
}

TEST(SlamContinue, AnEmptyMapBeginsAnew)
{
    Slam slam = after_scans(3);
    slam.continueIn(RtobMap(), Pose2{1, 2, 0});
    EXPECT_EQ(slam.state(), TrackingState::Init);
    slam.process(test::scan_in_house(0));
    EXPECT_EQ(slam.map().scans().size(), 1U);
    EXPECT_THAT(slam.pose(), IsNearPose(Pose2{1, 2, 0}, 1e-12, 1e-12));
}

// SPDX-License-Identifier: BSD-3-Clause
// A map that was made before, being lost in it, and being found again.
#include <gmock/gmock.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/slam/map_file.h>
#include <rtob/slam/slam.h>

#include <algorithm>
#include <optional>

#include "house.h"
#include "near_pose.h"

namespace rtob
{
namespace
{
using test::IsNearPose;

/// A map of one lap.
const RtobMap& house_map()
{
    static const RtobMap map = []
    {
        Slam slam;
        for (int k = 0; k < test::house_lap_scans; ++k) slam.process(test::scan_in_house(k));
        return slam.map();
    }();
    return map;
}

SlamOptions localising()
{
    SlamOptions options;
    options.map.file = "any";  // what asks for one to be given
    options.map.localize = true;
    return options;
}

/// @return scans until TRACKING, or 0; the last pose is to be right.
int scans_until_found(Slam& slam, int first)
{
    for (int k = 0; k < 10; ++k)
    {
        const auto& report = slam.process(test::scan_in_house(first + k));
        if (report.state != TrackingState::Tracking) continue;
        EXPECT_THAT(
            report.pose_map_vehicle, IsNearPose(test::pose_in_house_map(first + k), 0.1, 0.03));
        return k + 1;
    }
    return 0;
}

TEST(SlamRecovery, LocalisingWritesNothing)
{
    Slam slam(localising());
    slam.continueIn(house_map(), test::pose_in_house_map(50));
    for (int k = 50; k < 150; ++k)
    {
        const auto& report = slam.process(test::scan_in_house(k));
        ASSERT_EQ(report.state, TrackingState::Tracking) << k;
        ASSERT_THAT(report.pose_map_vehicle, IsNearPose(test::pose_in_house_map(k), 0.05, 0.02));
    }
    EXPECT_EQ(map_checksum(slam.map()), map_checksum(house_map()));
}

TEST(SlamRecovery, WithoutAPoseItIsFoundAndThenTheMapIsContinued)
{
    for (const bool localise : {true, false})
    {
        Slam slam(localise ? localising() : SlamOptions{});
        slam.continueIn(house_map(), std::nullopt);
        EXPECT_EQ(slam.state(), TrackingState::Lost);
        const int scans = scans_until_found(slam, 230);
        EXPECT_GT(scans, 0);
        EXPECT_EQ(map_checksum(slam.map()), map_checksum(house_map()));
        for (int k = 0; k < 20; ++k) slam.process(test::scan_in_house(230 + scans + k));
        EXPECT_EQ(slam.state(), TrackingState::Tracking);
        EXPECT_EQ(slam.map().scans().size() == house_map().scans().size(), localise);
    }
}

TEST(SlamRecovery, CarriedAwayItIsLostWithinFiveScansAndFoundAgain)
{
    Slam slam;
    slam.continueIn(house_map(), test::pose_in_house_map(20));
    for (int k = 20; k < 40; ++k) slam.process(test::scan_in_house(k));
    ASSERT_EQ(slam.state(), TrackingState::Tracking);
    const auto before = map_checksum(slam.map());
    int lost_after = 0;
    for (int k = 0; k < 5 && lost_after == 0; ++k)
        if (slam.process(test::scan_in_house(200 + k)).state == TrackingState::Lost)
            lost_after = k + 1;
    EXPECT_GT(lost_after, 0);
    EXPECT_GT(scans_until_found(slam, 200 + lost_after), 0);
    EXPECT_EQ(map_checksum(slam.map()), before);
}

/// The scans of seconds are missing, in which the vehicle, with odometry, drove into the other
/// room: what it sees does not follow what it saw, yet it is where it is thought to be.
TEST(SlamRecovery, AGapInTheScansIsNoKidnapping)
{
    Slam slam;
    slam.continueIn(house_map(), test::pose_in_house_map(20));
    const auto take = [&slam](int k)
    {
        mrpt::obs::CObservationOdometry odometry;
        const Pose2 pose = test::pose_in_house(k);
        const double slip_m = k < 100 ? 0 : 0.12;  // of the wheels, in the gap
        odometry.odometry = {pose.x + slip_m, pose.y, pose.yaw};
        slam.observe(odometry);
        return slam.process(test::scan_in_house(k));
    };
    for (int k = 20; k < 40; ++k) take(k);
    ASSERT_EQ(slam.state(), TrackingState::Tracking);
    const auto before = map_checksum(slam.map());
    int doubted = 0;
    for (int k = 140; k < 160; ++k)
    {
        const auto report = take(k);
        ASSERT_THAT(report.pose_map_vehicle, IsNearPose(test::pose_in_house_map(k), 0.05, 0.02));
        if (report.state == TrackingState::Tracking) continue;
        EXPECT_EQ(report.state, TrackingState::Degraded) << k;
        EXPECT_EQ(map_checksum(slam.map()), before) << k;
        ++doubted;
    }
    EXPECT_LE(doubted, 4);
    EXPECT_EQ(slam.state(), TrackingState::Tracking);
}

TEST(SlamRecovery, ACoveredLaserIsNoticed)
{
    Slam slam;
    slam.continueIn(house_map(), test::pose_in_house_map(20));
    for (int k = 20; k < 40; ++k) slam.process(test::scan_in_house(k));
    const auto before = map_checksum(slam.map());
    for (int k = 0; k < 8; ++k)
    {
        auto scan = test::scan_in_house(40 + k);
        for (std::size_t i = 0; i < scan.getScanSize(); ++i)
        {
            scan.setScanRange(i, 0.3F);
            scan.setScanRangeValidity(i, true);
        }
        const auto& report = slam.process(scan);
        EXPECT_NE(report.state, TrackingState::Tracking) << k;
        if (k >= 4)
        {
            EXPECT_EQ(report.state, TrackingState::Lost) << k;
        }
    }
    EXPECT_GT(scans_until_found(slam, 48), 0);
    EXPECT_EQ(map_checksum(slam.map()), before);
}

TEST(SlamRecovery, AMapUnderACapIsThinnedAndStillTracked)
{
    SlamOptions options;
    options.map.max_points = 40'000;  // about 110 scans
    Slam slam(options);
    std::size_t most = 0;
    for (int k = 0; k < 2 * test::house_lap_scans; ++k)
    {
        const auto& report = slam.process(test::scan_in_house(k));
        ASSERT_EQ(report.state, TrackingState::Tracking) << k;
        ASSERT_THAT(report.pose_map_vehicle, IsNearPose(test::pose_in_house_map(k), 0.1, 0.03))
            << k;
        most = std::max(most, slam.map().size());
    }
    EXPECT_LE(most, 40'000U);
    EXPECT_GT(most, 30'000U);
}
}  // namespace
}  // namespace rtob

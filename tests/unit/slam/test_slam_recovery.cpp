// SPDX-License-Identifier: BSD-3-Clause
// A map that was made before, being lost in it, and being found again.
#include <gmock/gmock.h>
#include <rtob/slam/map_file.h>
#include <rtob/slam/slam.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "house.h"
#include "near_pose.h"
#include "room_mrpt.h"

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

/// A room that begins at this x; two of them look the same but for what stands in them.
test::Room room_at(double x0, bool has_pillars)
{
    std::vector<test::Wall> walls{{x0, 0, x0 + 6, 0}, {x0 + 6, 0, x0 + 6, 4},
                                  {x0 + 6, 4, x0, 4}, {x0, 4, x0, 0},
                                  {x0, 3, x0 + 1, 3}, {x0 + 1, 3, x0 + 1, 4}};
    if (has_pillars)
    {
        test::add_circle(walls, x0 + 4, 0.8, 0.4);
        test::add_circle(walls, x0 + 2.5, 3.2, 0.4);
    }
    return test::Room(walls);
}

constexpr double kOtherRoom_m = 20;

Pose2 pose_in_room(double x0, int scan)
{
    return {x0 + 2 + 0.05 * scan, 1.8, 0.3};
}

/// The first room is bare; the second has pillars.
RtobMap map_of_rooms(bool has_second)
{
    RtobMap map;
    for (const double x0 : {0.0, kOtherRoom_m})
        for (int scan = 0; scan < 40 && (x0 == 0 || has_second); scan += 4)
            map.insertScan(
                map.tick(0.1 * scan), pose_in_room(x0, scan),
                room_at(x0, x0 > 0).scan_vehicle(pose_in_room(x0, scan)).view());
    return map;
}

/// Drives in the first room, and then stands and sees pillars, after a step that nobody foresaw.
/// @return the reports from then on, until it is lost
std::vector<ScanReport> see_pillars(Slam& slam, bool has_second)
{
    slam.continueIn(map_of_rooms(has_second), pose_in_room(0, 0));
    const auto take = [&slam](const test::Room& room, const Pose2& pose, int scan) {
        return slam.process(
            test::scan_observation(room, pose, 1000 + 0.1 * scan, test::mrpt_laser()));
    };
    for (int scan = 0; scan < 10; ++scan)
        EXPECT_EQ(
            take(room_at(0, false), pose_in_room(0, scan), scan).state, TrackingState::Tracking);
    std::vector<ScanReport> reports;
    for (int scan = 10; scan < 20; ++scan)
    {
        const Pose2 pose = compose(pose_in_room(0, 10), {0.15, 0.1, 0.1});
        reports.push_back(take(room_at(0, true), pose, scan));
        if (reports.back().state != TrackingState::Tracking) break;
    }
    return reports;
}

/// They stand in the other room, so the vehicle was carried there.
TEST(SlamRecovery, WhatWasWrittenInDoubtIsTakenBack)
{
    SlamOptions trusting;
    trusting.tracking.min_agreement = 0;
    Slam slam, slam_trusting(trusting);
    const auto reports = see_pillars(slam, true), believed = see_pillars(slam_trusting, true);
    EXPECT_EQ(slam.state(), TrackingState::Relocalising);
    EXPECT_LE(reports.size(), 5u);
    EXPECT_EQ(believed.back().state, TrackingState::Tracking) << "it does fit where it is not";
    const auto written = std::count_if(
        reports.begin(), reports.end(), [](const auto& report) { return report.inserted; });
    EXPECT_GT(written, 0);
    for (const ScanReport& report : reports) EXPECT_EQ(report.doubted, &report != &reports.back());
    // What the map has are the scans of the first room.
    const auto& scans = slam.map().scans();
    ASSERT_GT(scans.size(), map_of_rooms(true).scans().size());
    const double last_s = reports.front().map_time_s;
    EXPECT_LT(scans.time(scans.size() - 1), last_s);
    EXPECT_GT(slam_trusting.map().scans().size(), scans.size());
}

/// They were put into the room: no other place looks like that. The doubt changes nothing, to the
/// last bit.
TEST(SlamRecovery, ADoubtThatIsDispelledChangesNothing)
{
    SlamOptions trusting;
    trusting.tracking.min_agreement = 0;
    Slam slam, slam_trusting(trusting);
    const auto reports = see_pillars(slam, false), expected = see_pillars(slam_trusting, false);
    ASSERT_EQ(reports.size(), expected.size());
    EXPECT_TRUE(reports.front().doubted);
    EXPECT_FALSE(reports.back().doubted);
    for (std::size_t i = 0; i < reports.size(); ++i)
    {
        EXPECT_EQ(reports[i].state, TrackingState::Tracking) << i;
        EXPECT_THAT(reports[i].pose_map_vehicle, IsNearPose(expected[i].pose_map_vehicle, 0, 0));
    }
    EXPECT_EQ(map_checksum(slam.map()), map_checksum(slam_trusting.map()));
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

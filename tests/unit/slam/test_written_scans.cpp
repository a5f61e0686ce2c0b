// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <near_pose.h>
#include <rtob/map/conversions.h>
#include <rtob/slam/written_scans.h>

using namespace rtob;
using rtob::test::IsNearPose;

namespace
{
/// Scans at x = 0, 1 ... m, written one a second, in a table like a map's.
struct Drive
{
    WrittenScans written;
    ScanTable scans;

    explicit Drive(int scan_count)
    {
        for (int i = 0; i < scan_count; ++i) add(i, {1.0 * i, 0, 0});
    }

    void add(double map_time_s, const Pose2& pose)
    {
        ScanReport report;
        report.map_time_s = map_time_s;
        report.pose_map_vehicle = pose;
        report.inserted = true;
        const auto scan = mrpt::obs::CObservation2DRangeScan::Create();
        scan->sensorLabel = std::to_string(pose.x);
        written.add(scan, report);
        scans.append(map_time_s, pose, 1);
    }
};

/// Where a frame is, and which scan it holds.
std::pair<Pose2, std::string> frame_of(const mrpt::maps::CSimpleMap& map, std::size_t index)
{
    mrpt::poses::CPose3DPDF::ConstPtr pose;
    mrpt::obs::CSensoryFrame::ConstPtr frame;
    map.get(index, pose, frame);
    return {
        to_pose2(mrpt::poses::CPose2D(pose->getMeanVal())),
        frame->getObservationByIndex(0)->sensorLabel};
}
}  // namespace

TEST(WrittenScans, AreAFrameEachWhereTheMapHasThemNow)
{
    Drive drive(3);
    drive.scans.move(2, {2, 7, 0.5});
    const auto map = drive.written.in(drive.scans);
    ASSERT_EQ(map.size(), 3u);
    EXPECT_THAT(frame_of(map, 1).first, IsNearPose(Pose2({1, 0, 0}), 1e-9, 1e-9));
    EXPECT_THAT(frame_of(map, 2).first, IsNearPose(Pose2({2, 7, 0.5}), 1e-9, 1e-9));
}

TEST(WrittenScans, WhatTheMapHasForgottenIsNotThere)
{
    Drive drive(5);
    drive.scans.keepOnly({0, 1, 0, 1, 0});
    const auto map = drive.written.in(drive.scans);
    ASSERT_EQ(map.size(), 2u);
    EXPECT_EQ(frame_of(map, 0).second, std::to_string(1.0));
    EXPECT_EQ(frame_of(map, 1).second, std::to_string(3.0));
}

TEST(WrittenScans, TwoLasersMayShareATime)
{
    Drive drive(1);
    drive.add(0, {5, 0, 0});
    const auto map = drive.written.in(drive.scans);
    ASSERT_EQ(map.size(), 2u);
    EXPECT_EQ(frame_of(map, 1).second, std::to_string(5.0));
    EXPECT_NEAR(frame_of(map, 1).first.x, 5, 1e-9);
}

TEST(WrittenScans, AScanThatWasNotWrittenIsNotKept)
{
    Drive drive(1);
    drive.written.add(mrpt::obs::CObservation2DRangeScan::Create(), ScanReport());
    EXPECT_EQ(drive.written.in(drive.scans).size(), 1u);
}

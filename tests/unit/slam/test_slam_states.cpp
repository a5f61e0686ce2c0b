// SPDX-License-Identifier: BSD-3-Clause
// What may enter the map, and when.
#include <gtest/gtest.h>
#include <rtob/map/match_sample.h>
#include <rtob/slam/slam.h>

#include <limits>

#include "drive_log.h"
#include "near_pose.h"
#include "worlds.h"

using namespace rtob;
using test::drive_start_s;
using test::drive_step_s;
using test::IsNearPose;
using test::pose_on_circle_map;
using test::scan_of;
using test::scan_on_circle;

namespace
{
double stamp_of(int scan)
{
    return drive_start_s + scan * drive_step_s;
}

std::uint64_t fingerprint(const Slam& slam)
{
    return scan_hash(slam.map().points());
}

/// A drive of so many scans.
Slam driven(int scans, const SlamOptions& options = {})
{
    Slam slam(options);
    for (int k = 0; k < scans; ++k) slam.process(*scan_on_circle(k));
    return slam;
}

/// A scan of quite another place: a round hall, much wider than the room.
mrpt::obs::CObservation2DRangeScan scan_elsewhere(int scan)
{
    std::vector<test::Wall> walls;
    test::add_circle(walls, 0, 0, 5);
    return test::scan_observation(test::Room(walls), {}, stamp_of(scan), test::mrpt_laser());
}

constexpr float nan_m = std::numeric_limits<float>::quiet_NaN();

/// Scans that say nothing about where the vehicle is.
std::vector<mrpt::obs::CObservation2DRangeScan::Ptr> useless_scans(int scan)
{
    const double stamp_s = stamp_of(scan);
    return {scan_of(0, 1, true, stamp_s),       scan_of(1, 1, true, stamp_s),
            scan_of(361, 1, false, stamp_s),    scan_of(361, nan_m, true, stamp_s),
            scan_of(361, -1, true, stamp_s),    scan_of(361, 0, true, stamp_s),
            scan_of(361, 81.83f, true, stamp_s)};
}
}  // namespace

TEST(SlamStates, TheFirstUsableScanStartsTheMapAndIsWritten)
{
    Slam slam;
    EXPECT_EQ(slam.state(), TrackingState::Init);
    const ScanReport& report = slam.process(*scan_on_circle(0));
    EXPECT_EQ(report.state, TrackingState::Tracking);
    EXPECT_TRUE(report.inserted);
    EXPECT_THAT(report.pose_map_vehicle, IsNearPose(Pose2{}, 0.0, 0.0));
    EXPECT_TRUE(report.covariance.isZero()) << "the map's frame is the first pose";
    EXPECT_EQ(slam.map().scans().size(), 1U);
    EXPECT_EQ(slam.map().points().size, report.beams.used);
}

TEST(SlamStates, AUselessFirstScanStartsNothing)
{
    for (const auto& useless : useless_scans(0))
    {
        Slam slam;
        const ScanReport& report = slam.process(*useless);
        EXPECT_EQ(report.state, TrackingState::Init) << useless->getScanSize();
        EXPECT_FALSE(report.inserted);
        EXPECT_TRUE(slam.map().scans().empty());
        slam.process(*scan_on_circle(1));
        EXPECT_EQ(slam.state(), TrackingState::Tracking);
    }
}

TEST(SlamStates, AUselessScanGivesThePredictionAndChangesNothing)
{
    for (const auto& useless : useless_scans(20))
    {
        Slam slam = driven(20);
        const auto before = fingerprint(slam);
        const double sigma2_m2 = slam.process(*scan_on_circle(20)).covariance(0, 0);
        const auto with_20 = fingerprint(slam);
        ASSERT_NE(before, with_20);

        useless->timestamp = mrpt::Clock::fromDouble(stamp_of(21));
        const ScanReport& report = slam.process(*useless);
        EXPECT_EQ(report.state, TrackingState::Degraded);
        EXPECT_FALSE(report.inserted);
        EXPECT_EQ(fingerprint(slam), with_20);
        // The last step carried on: the circle is left by less than a millimetre a step.
        EXPECT_THAT(report.pose_map_vehicle, IsNearPose(pose_on_circle_map(21), 0.01, 0.01));
        EXPECT_GT(report.covariance(0, 0), sigma2_m2);

        EXPECT_EQ(slam.process(*scan_on_circle(22)).state, TrackingState::Tracking);
        EXPECT_THAT(slam.pose(), IsNearPose(pose_on_circle_map(22), 0.01, 0.01));
    }
}

TEST(SlamStates, AKidnappedVehicleIsLostAndLeavesTheMapAlone)
{
    SlamOptions options;
    options.tracking.lost_after = 5;
    Slam slam = driven(30, options);
    const auto before = fingerprint(slam);
    for (int k = 0; k < 20; ++k)
    {
        const ScanReport& report = slam.process(scan_elsewhere(30 + k));
        EXPECT_EQ(report.state, k < 4 ? TrackingState::Degraded : TrackingState::Lost) << k;
        EXPECT_FALSE(report.inserted);
        EXPECT_TRUE(report.searched);
        EXPECT_EQ(fingerprint(slam), before);
    }
}

TEST(SlamStates, BackInTheMapItIsFoundAndConfirmedBeforeItWrites)
{
    SlamOptions options;
    options.tracking.lost_after = 5;
    options.relocalise.confirm_scans = 3;
    Slam slam = driven(60, options);  // once around
    const auto before = fingerprint(slam);
    for (int k = 60; k < 70; ++k) slam.process(scan_elsewhere(k));
    ASSERT_EQ(slam.state(), TrackingState::Lost);
    // It is put down on the far side of the circle, 1 m away and turned.
    EXPECT_EQ(slam.process(*scan_on_circle(90)).state, TrackingState::Relocalising);
    EXPECT_EQ(slam.process(*scan_on_circle(91)).state, TrackingState::Relocalising);
    EXPECT_EQ(fingerprint(slam), before);
    EXPECT_EQ(slam.process(*scan_on_circle(92)).state, TrackingState::Tracking);
    EXPECT_THAT(slam.pose(), IsNearPose(pose_on_circle_map(92), 0.05, 0.02));  // to a raster cell
    EXPECT_TRUE(slam.process(*scan_on_circle(93)).inserted);
    EXPECT_THAT(slam.pose(), IsNearPose(pose_on_circle_map(93), 0.01, 0.01));
}

TEST(SlamStates, WithoutRelocalisationAWindowIsSearched)
{
    SlamOptions options;
    options.relocalise.enabled = false;
    options.tracking.confirm_after = 2;
    Slam slam = driven(60, options);
    for (int k = 60; k < 70; ++k) slam.process(scan_elsewhere(k));
    ASSERT_EQ(slam.state(), TrackingState::Lost);
    EXPECT_EQ(slam.process(*scan_on_circle(90)).state, TrackingState::Relocalising);
    EXPECT_THAT(slam.pose(), IsNearPose(pose_on_circle_map(90), 0.01, 0.01));
    EXPECT_EQ(slam.process(*scan_on_circle(91)).state, TrackingState::Tracking);
}

TEST(SlamStates, NothingIsWrittenWhileNotTracking)
{
    // Every kind of scan in a wild order.
    Slam slam;
    Random random(1);
    int not_tracking = 0;
    for (int k = 0; k < 150; ++k)
    {
        const auto before = fingerprint(slam);
        const auto kind = random.below(4);
        const ScanReport& report = kind == 0   ? slam.process(scan_elsewhere(k))
                                   : kind == 1 ? slam.process(*useless_scans(k)[random.below(7)])
                                               : slam.process(*scan_on_circle(k));
        not_tracking += report.state != TrackingState::Tracking;
        if (report.state != TrackingState::Tracking)
        {
            EXPECT_FALSE(report.inserted) << k;
            EXPECT_EQ(fingerprint(slam), before) << k;
        }
    }
    EXPECT_GT(not_tracking, 20);
}

TEST(SlamStates, AResetPutsTheVehicleElsewhereInTheMap)
{
    SlamOptions options;
    options.search.enabled = false;  // so that it is the reset that finds the place
    Slam slam = driven(60, options);
    slam.reset(pose_on_circle_map(95));
    EXPECT_THAT(slam.pose(), IsNearPose(pose_on_circle_map(95), 0.0, 0.0));
    EXPECT_EQ(slam.process(*scan_on_circle(95)).state, TrackingState::Tracking);
    EXPECT_THAT(slam.pose(), IsNearPose(pose_on_circle_map(95), 0.01, 0.01));
}

TEST(SlamOptions, AreCheckedByTheConstructor)
{
    SlamOptions options;
    options.draw.points = 0;
    EXPECT_THROW(Slam{options}, std::invalid_argument);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <run/guard_replay.h>
#include <usage_error.h>

using namespace rtob;

namespace
{
/// Five beams over a half turn: right, half right, ahead, half left, left.
mrpt::obs::CObservation2DRangeScan half_turn(bool right_to_left = true)
{
    mrpt::obs::CObservation2DRangeScan scan;
    scan.timestamp = mrpt::Clock::fromDouble(100);
    scan.aperture = static_cast<float>(M_PI);
    scan.maxRange = 6;
    scan.rightToLeft = right_to_left;
    scan.resizeScan(5);
    for (std::size_t i = 0; i < 5; ++i)
    {
        scan.setScanRange(i, 1.0F + static_cast<float>(i));
        scan.setScanRangeValidity(i, true);
    }
    return scan;
}

MapPose pose_at(double stamp_s, const Pose2& pose_map_vehicle)
{
    MapPose pose;
    pose.stamp_s = stamp_s;
    pose.pose_map_vehicle = pose_map_vehicle;
    pose.is_lost = false;
    return pose;
}
}  // namespace

TEST(GuardFeed, TakesBeamsWithTheirBearings)
{
    GuardFeed feed{SlamOptions()};
    const GuardScan& scan = feed.scanOf(half_turn(), 0.1);
    EXPECT_NEAR(scan.first_bearing_rad, -M_PI / 2, 1e-6);
    EXPECT_NEAR(scan.step_rad, M_PI / 4, 1e-6);
    EXPECT_EQ(scan.end_s(), 100.1);
    EXPECT_EQ(scan.max_range_m, 6);
    ASSERT_EQ(scan.beams, 5u);
    EXPECT_EQ(scan.ranges_m[2], 3);
    EXPECT_NEAR(feed.scanOf(half_turn(false), 0).first_bearing_rad, M_PI / 2, 1e-6);
}

TEST(GuardFeed, ALaserThatHangsSeesLeftAsRight)
{
    SlamOptions options;
    options.sensor.override_mount = true;
    options.sensor.upside_down = true;
    options.sensor.mount_x_m = 0.2;
    GuardFeed feed(options);
    const GuardScan& scan = feed.scanOf(half_turn(), 0);
    EXPECT_NEAR(scan.first_bearing_rad, M_PI / 2, 1e-6);
    EXPECT_NEAR(scan.step_rad, -M_PI / 4, 1e-6);
    EXPECT_NEAR(scan.pose_vehicle_laser.x, 0.2, 1e-9);
}

TEST(GuardFeed, DropsWhatMeansNothing)
{
    SlamOptions options;
    options.scan_filter.mask_deg = "-50..-40";  // sees the vehicle itself
    options.scan_filter.min_range_m = 1.5;
    options.scan_filter.max_range_m = 4.5;
    GuardFeed feed(options);
    auto observation = half_turn();
    observation.setScanRangeValidity(2, false);
    const GuardScan& scan = feed.scanOf(observation, 0);
    EXPECT_EQ(
        std::vector<float>(scan.ranges_m, scan.ranges_m + 5), (std::vector<float>{0, 0, 0, 4, 0}));
}

TEST(GuardFeed, TellsTheMotionBetweenTwoPoses)
{
    GuardFeed feed{SlamOptions()};
    EXPECT_FALSE(feed.motion(100));
    feed.add(pose_at(100, {1, 1, M_PI / 2}));
    EXPECT_FALSE(feed.motion(100));
    feed.add(pose_at(100.1, {1, 1.05, M_PI / 2}));  // 5 cm ahead
    const auto motion = feed.motion(100.2);
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->velocity_vehicle.x(), 0.5, 1e-9);
    EXPECT_NEAR(motion->velocity_vehicle.y(), 0, 1e-9);
    EXPECT_FALSE(feed.motion(100.7));  // long ago
    MapPose lost = pose_at(100.2, {1, 1.1, M_PI / 2});
    lost.is_lost = true;
    feed.add(lost);
    EXPECT_FALSE(feed.motion(100.2));
}

TEST(GuardFeed, TakesThePosesLargerAxis)
{
    ScanReport report;
    report.state = TrackingState::Tracking;
    report.covariance << 0.0025, 0.0015, 0, 0.0015, 0.0025, 0, 0, 0, 1;  // axes 0.004 and 0.001
    EXPECT_NEAR(GuardFeed::poseOf(report, 100).sigma_m, std::sqrt(0.004), 1e-12);
    EXPECT_FALSE(GuardFeed::poseOf(report, 100).is_lost);
    report.state = TrackingState::Lost;
    EXPECT_TRUE(GuardFeed::poseOf(report, 100).is_lost);
}

TEST(GuardWish, IsDrivenOrAVelocity)
{
    EXPECT_TRUE(parse_guard_wish("driven").as_driven);
    const GuardWish wish = parse_guard_wish("0.5,-0.25");
    EXPECT_FALSE(wish.as_driven);
    EXPECT_EQ(wish.velocity_vehicle, Eigen::Vector2d(0.5, -0.25));
    for (const char* wrong : {"", "0.5", "a,b", "1,nan", "1,2,3"})
        EXPECT_THROW(static_cast<void>(parse_guard_wish(wrong)), UsageError) << wrong;
}

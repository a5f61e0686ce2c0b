// SPDX-License-Identifier: BSD-3-Clause
// Stamps of real logs repeat, step back and jump; the order of arrival is the truth.
#include <gtest/gtest.h>
#include <rtob/slam/slam.h>

#include <cmath>
#include <functional>

#include "drive_log.h"
#include "near_pose.h"

using namespace rtob;
using test::IsNearPose;

namespace
{
/// Drives with stamps of one's own; all of it must be tracked.
void expect_tracked(const std::function<double(int)>& stamp_of)
{
    Slam slam;
    double last_time_s = 0;
    for (int k = 0; k < 40; ++k)
    {
        auto scan = test::scan_on_circle(k);
        scan->timestamp = mrpt::Clock::fromDouble(stamp_of(k));
        const ScanReport& report = slam.process(*scan);
        EXPECT_EQ(report.state, TrackingState::Tracking) << k;
        EXPECT_THAT(report.pose_map_vehicle, IsNearPose(test::pose_on_circle_map(k), 0.01, 0.01))
            << k;
        EXPECT_NEAR(report.stamp_s, stamp_of(k), 1e-6) << "the log's own";
        EXPECT_GE(report.map_time_s, last_time_s);
        EXPECT_LE(report.map_time_s, last_time_s + 10) << "a jump is cut";
        last_time_s = report.map_time_s;
    }
    EXPECT_EQ(slam.map().scans().size(), 40U);
}
}  // namespace

TEST(SlamStamps, MayStandStill)
{
    expect_tracked([](int) { return 1e9; });
    expect_tracked([](int k) { return 1e9 + 0.2 * (k / 2); });
}

TEST(SlamStamps, MayStepBack)
{
    expect_tracked([](int k) { return 1e9 + 0.1 * k - (k % 5 == 4 ? 0.9 : 0.0); });
    expect_tracked([](int k) { return 1e9 - 0.1 * k; });
}

TEST(SlamStamps, MayJumpByADay)
{
    expect_tracked([](int k) { return 1e9 + 0.1 * k + (k >= 20 ? 86400.0 : 0.0); });
    expect_tracked([](int k) { return 1e9 + 0.1 * k - (k >= 20 ? 86400.0 : 0.0); });
}

TEST(SlamStamps, MayBeMissing)
{
    Slam slam;
    for (int k = 0; k < 20; ++k)
    {
        auto scan = test::scan_on_circle(k);
        scan->timestamp = INVALID_TIMESTAMP;
        const ScanReport& report = slam.process(*scan);
        EXPECT_TRUE(std::isnan(report.stamp_s));
        EXPECT_EQ(report.map_time_s, 0);
        EXPECT_EQ(report.state, TrackingState::Tracking) << k;
    }
    EXPECT_THAT(slam.pose(), IsNearPose(test::pose_on_circle_map(19), 0.01, 0.01));
    EXPECT_EQ(slam.map().clock().anomalies().invalid, 20U);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/system/CObserver.h>
#include <rtob/map/rtob_map.h>

#include "room_mrpt.h"

#include <algorithm>
#include <cmath>
#include <limits>

using rtob::Pose2;
using rtob::RtobMap;
using rtob::test::mrpt_laser;
using rtob::test::room_4x3;
using rtob::test::scan_observation;

TEST(RtobMapInsertObservation, KeepsAnEntryForEachScan)
{
    RtobMap map;
    const auto room = room_4x3();
    for (int k = 0; k < 3; ++k)
    {
        const Pose2 pose{1.0 + 0.1 * k, 1, 0.2};
        ASSERT_TRUE(map.insertObservation(
            scan_observation(room, pose, 1000 + 0.2 * k, mrpt_laser()),
            mrpt::poses::CPose3D(pose.x, pose.y, 0, pose.yaw, 0, 0)));
    }
    ASSERT_EQ(map.scans().size(), 3u);
    EXPECT_NEAR(map.scans().time(2), 0.4, 1e-6);  // MRPT's clock ticks every 100 ns
    EXPECT_NEAR(map.scans().x(2), 1.2, 1e-12);
    EXPECT_EQ(map.scans().pointCount(), map.size());
    // Every point lies on a wall of the room.
    for (std::size_t i = 0; i < map.size(); ++i)
    {
        const double x = map.points().x[i], y = map.points().y[i];
        const double to_wall = std::min(
            {std::abs(x), std::abs(y), std::abs(4 - x), std::abs(3 - y),
             x > 2.99 && y > 1.99 ? std::min(std::abs(x - 3), std::abs(y - 2)) : 9.0});
        ASSERT_NEAR(to_wall, 0, 1e-4);
    }
}

TEST(RtobMapInsertObservation, NeverFusesPoints)
{
    RtobMap map;
    map.insertionOptions.fuseWithExisting = true;
    const auto scan = scan_observation(room_4x3(), {1, 1, 0}, 1, mrpt_laser());
    map.insertObservation(scan);
    const auto once = map.size();
    map.insertObservation(scan);
    EXPECT_EQ(map.size(), 2 * once);
    EXPECT_EQ(map.scans().size(), 2u);
}

TEST(RtobMapInsertObservation, ReportsAScanWithoutReturns)
{
    RtobMap map;
    auto scan = scan_observation(room_4x3(), {1, 1, 0}, 1, mrpt_laser());
    for (std::size_t i = 0; i < scan.getScanSize(); ++i) scan.setScanRangeValidity(i, false);
    EXPECT_FALSE(map.insertObservation(scan));
    scan.resizeScan(0);
    EXPECT_FALSE(map.insertObservation(scan));
    EXPECT_FALSE(map.insertObservation(mrpt::obs::CObservationOdometry()));
    EXPECT_TRUE(map.scans().empty());
}

TEST(RtobMapInsertObservation, DropsRangesThatAreNoNumbers)
{
    RtobMap map;
    auto scan = scan_observation(room_4x3(), {1, 1, 0}, 1, mrpt_laser());
    map.insertionOptions.minDistBetweenLaserPoints = 0;
    scan.setScanRange(10, std::numeric_limits<float>::quiet_NaN());
    scan.setScanRange(11, std::numeric_limits<float>::infinity());
    ASSERT_TRUE(map.insertObservation(scan));
    for (std::size_t i = 0; i < map.size(); ++i)
        ASSERT_TRUE(std::isfinite(map.points().x[i]) && std::isfinite(map.points().y[i])) << i;
    EXPECT_NO_THROW((void)map.view());
}

TEST(RtobMapInsertObservation, AcceptsScansWithoutAStamp)
{
    RtobMap map;
    auto scan = scan_observation(room_4x3(), {1, 1, 0}, 1, mrpt_laser());
    scan.timestamp = INVALID_TIMESTAMP;
    ASSERT_TRUE(map.insertObservation(scan));
    EXPECT_EQ(map.clock().anomalies().invalid, 1u);
    EXPECT_EQ(map.scans().time(0), 0.0);
}

TEST(RtobMapInsertObservation, TellsObservers)
{
    struct Counter : mrpt::system::CObserver
    {
        int events = 0;
        void OnEvent(const mrpt::system::mrptEvent&) override { ++events; }
    };
    RtobMap map;
    Counter counter;
    counter.observeBegin(map);
    map.insertObservation(scan_observation(room_4x3(), {1, 1, 0}, 1, mrpt_laser()));
    EXPECT_EQ(counter.events, 1);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <rtob/io/rawlog_writer.h>

#include "drive_log.h"
#include "same_scan.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
ReadLog there_and_back(const LogObjects& objects)
{
    const TemporaryFolder folder;
    RawlogWriter writer(folder.file("b.rawlog"));
    const auto log = open_log(folder.write("a.rawlog", rawlog_bytes(objects)));
    while (const auto entry = log->next()) writer.write(*entry);
    writer.commit();
    return read_log(folder.file("b.rawlog"));
}

mrpt::obs::CActionCollection::Ptr action_of(double forward_m, double turn_rad)
{
    mrpt::obs::CActionRobotMovement2D movement;
    movement.computeFromOdometry(mrpt::poses::CPose2D(forward_m, 0, turn_rad), {});
    auto actions = mrpt::obs::CActionCollection::Create();
    actions->insert(movement);
    return actions;
}

mrpt::obs::CSensoryFrame::Ptr frame_of(const mrpt::obs::CObservation::Ptr& observation)
{
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(observation);
    return frame;
}

TEST(RawlogWriter, KeepsObservationsOfEveryKindAndTheirOrder)
{
    auto imu = mrpt::obs::CObservationIMU::Create();
    imu->sensorLabel = "imu";
    const auto log =
        there_and_back({scan_on_circle(0), imu, odometry_on_circle(1), scan_on_circle(2)});
    ASSERT_EQ(log.entries.size(), 4U);
    EXPECT_EQ(difference(*log.scans().at(0), *scan_on_circle(0)), "");
    EXPECT_EQ(log.entries[1].observation->sensorLabel, "imu");
    EXPECT_EQ(log.odometry().at(0)->odometry.phi(), odometry_on_circle(1)->odometry.phi());
    EXPECT_EQ(difference(*log.scans().at(1), *scan_on_circle(2)), "");
}

/// 1 m ahead, a quarter turn to the left, 2 m ahead: at (1, 2), looking left.
TEST(RawlogWriter, SumsMotionsUpBeforeTheNextObservation)
{
    constexpr double quarter = 1.57079632679489662;
    const auto log = there_and_back(
        {frame_of(scan_on_circle(0)), action_of(1, quarter), action_of(2, 0),
         frame_of(scan_on_circle(1))});
    ASSERT_EQ(log.entries.size(), 3U);
    const auto odometry = log.odometry().at(0);
    EXPECT_EQ(log.entries[1].observation, odometry);
    EXPECT_EQ(odometry->timestamp, scan_on_circle(1)->timestamp);
    EXPECT_NEAR(odometry->odometry.x(), 1, 1e-12);
    EXPECT_NEAR(odometry->odometry.y(), 2, 1e-12);
    EXPECT_NEAR(odometry->odometry.phi(), quarter, 1e-12);
}

TEST(RawlogWriter, KeepsAMotionAtTheEnd)
{
    const auto log = there_and_back({frame_of(scan_on_circle(0)), action_of(1, 0)});
    ASSERT_EQ(log.odometry().size(), 1U);
    EXPECT_EQ(log.odometry()[0]->timestamp, scan_on_circle(0)->timestamp);
}
}  // namespace
}  // namespace rtob::test

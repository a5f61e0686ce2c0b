// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "compare/log_survey.h"
#include "compare/scan_steps.h"
#include "drive_log.h"
#include "log_files.h"
#include "near_pose.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

std::vector<ScanStep> steps_of(
    const LogObjects& objects, const RunConfig& config = {}, const RunLimits& limits = {})
{
    const TemporaryFile file(".rawlog", rawlog_bytes(objects));
    ScanSteps source(file.path(), config, limits);
    std::vector<ScanStep> steps;
    while (auto step = source.next()) steps.push_back(*step);
    return steps;
}

TEST(ScanSteps, GivesEachScanTheOdometryBeforeIt)
{
    const auto steps = steps_of(drive_objects(3));
    ASSERT_EQ(steps.size(), 3u);
    for (int k = 0; k < 3; ++k)
    {
        const auto& step = steps[static_cast<std::size_t>(k)];
        ASSERT_TRUE(step.pose_odom_vehicle);
        EXPECT_THAT(*step.pose_odom_vehicle, IsNearPose(pose_on_circle(k), 1e-9, 1e-9));
        EXPECT_NEAR(step.time_s, k * drive_step_s, 1e-6);
    }
}

TEST(ScanSteps, OldOdometryIsNotGivenTwice)
{
    const auto steps = steps_of({odometry_on_circle(0), scan_on_circle(0), scan_on_circle(1)});
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_TRUE(steps[0].pose_odom_vehicle);
    EXPECT_FALSE(steps[1].pose_odom_vehicle);
}

TEST(ScanSteps, WithoutOdometryWhereItIsNotWanted)
{
    RunLimits limits;
    limits.use_odometry = false;
    for (const auto& step : steps_of(drive_objects(3), {}, limits))
        EXPECT_FALSE(step.pose_odom_vehicle);
}

TEST(ScanSteps, SkipsAndStopsAsAsked)
{
    RunLimits limits;
    limits.skip_scans = 2;
    limits.first_scans = 3;
    const auto steps = steps_of(drive_objects(10), {}, limits);
    ASSERT_EQ(steps.size(), 3u);
    EXPECT_NEAR(
        mrpt::Clock::toDouble(steps[0].scan->timestamp), drive_start_s + 2 * drive_step_s, 1e-6);
}

TEST(ScanSteps, BeamsThatOurFilterDropsAreInvalidForEverybody)
{
    const auto scan = scan_of(5, 2.0f, true, 1000);
    scan->setScanRange(0, 0.05f);
    scan->setScanRange(1, 9.0f);
    scan->setScanRange(2, std::numeric_limits<float>::quiet_NaN());
    scan->setScanRangeValidity(3, false);
    RunConfig config;
    config.slam.scan_filter.min_range_m = 0.1;
    config.slam.scan_filter.max_range_m = 8;
    const auto steps = steps_of({scan}, config);
    ASSERT_EQ(steps.size(), 1u);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_EQ(steps[0].scan->getScanRangeValidity(i), i == 4) << "beam " << i;
}

TEST(ScanSteps, TimeDoesNotRunBackAndStampsStay)
{
    const auto steps = steps_of(
        {scan_of(5, 1, true, 1001), scan_of(5, 1, true, 1000), scan_of(5, 1, true, 1000.5)});
    ASSERT_EQ(steps.size(), 3u);
    EXPECT_EQ(steps[1].time_s, 0);
    EXPECT_NEAR(steps[2].time_s, 0.5, 1e-6);
    EXPECT_NEAR(mrpt::Clock::toDouble(steps[1].scan->timestamp), 1000, 1e-6);
}

TEST(LogSurvey, CountsWhatAReaderOfTheReportShouldKnow)
{
    const TemporaryFile file(
        ".rawlog",
        rawlog_bytes(
            {scan_of(5, 1, true, 1001), scan_of(5, 1, true, 1000), scan_of(5, 1, true, 1000.5)}));
    const auto survey = survey_log(file.path(), {}, {});
    EXPECT_EQ(survey.scans.size(), 3u);
    EXPECT_EQ(survey.stamps_back, 1u);
    EXPECT_FALSE(survey.has_odometry);
    EXPECT_NEAR(survey.duration_s, 0.5, 1e-6);
}

TEST(LogSurvey, ALogThatIsCutIsReadUpToThere)
{
    const auto bytes = rawlog_bytes(drive_objects(4));
    const TemporaryFile file(".rawlog", bytes.substr(0, bytes.size() - 10));
    const auto survey = survey_log(file.path(), {}, {});
    EXPECT_EQ(survey.scans.size(), 3u);
    EXPECT_EQ(survey.read.end, RunEnd::DamagedLog);
    EXPECT_THAT(survey.read.damage, HasSubstr(file.path()));
}
}  // namespace
}  // namespace rtob::test

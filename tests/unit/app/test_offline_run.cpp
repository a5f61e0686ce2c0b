// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/obs/CActionRobotMovement2D.h>

#include "drive_log.h"
#include "near_pose.h"
#include "run/offline_run.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

/// A log in memory that may end in an error.
class MemoryLog : public LogReader
{
 public:
    explicit MemoryLog(std::vector<LogEntry> entries, bool damaged = false)
        : entries_(std::move(entries)), damaged_(damaged)
    {
    }
    std::optional<LogEntry> next() override
    {
        if (next_ < entries_.size()) return entries_[next_++];
        if (damaged_) throw LogError("a.log", "entry 7", "damaged", "Copy it again");
        return std::nullopt;
    }
    double progress() const override { return 0; }

 private:
    std::vector<LogEntry> entries_;
    std::size_t next_ = 0;
    bool damaged_;
};

std::vector<LogEntry> drive(int scans)
{
    std::vector<LogEntry> entries;
    for (const auto& object : drive_objects(scans))
        entries.push_back({std::dynamic_pointer_cast<mrpt::obs::CObservation>(object), nullptr});
    return entries;
}

struct Outcome
{
    OfflineRun run;
    std::vector<ScanReport> reports;
    bool has_odometry = false;
};

Outcome run_of(MemoryLog log, const RunLimits& limits = {}, std::size_t stop_after = 1000)
{
    Slam slam;
    Outcome outcome;
    outcome.run = run_log(
        log, slam, limits,
        [&](const auto&, const ScanReport& report) { outcome.reports.push_back(report); },
        [&] { return outcome.reports.size() >= stop_after; });
    outcome.has_odometry = slam.hasOdometry();
    return outcome;
}

TEST(RunLog, ReportsEveryScanInTheLogsOrder)
{
    const auto outcome = run_of(MemoryLog(drive(12)));
    EXPECT_EQ(outcome.run.end, RunEnd::LogEnd);
    EXPECT_EQ(outcome.run.scans, 12u);
    EXPECT_EQ(outcome.run.other_observations, 12u) << "odometry";
    ASSERT_EQ(outcome.reports.size(), 12u);
    for (int k = 0; k < 12; ++k)
        EXPECT_THAT(
            outcome.reports[static_cast<std::size_t>(k)].pose_map_vehicle,
            IsNearPose(pose_on_circle_map(k), 0.02, 0.01));
    EXPECT_TRUE(outcome.has_odometry);
}

TEST(RunLog, LeavesOdometryOfBothKindsAside)
{
    RunLimits limits;
    limits.use_odometry = false;
    auto entries = drive(3);
    const auto motion = mrpt::obs::CActionRobotMovement2D::Create();
    motion->computeFromOdometry(mrpt::poses::CPose2D(1, 0, 0), {});
    entries.insert(entries.begin() + 3, {nullptr, motion});
    EXPECT_FALSE(run_of(MemoryLog(entries), limits).has_odometry);
    EXPECT_TRUE(run_of(MemoryLog({{nullptr, motion}})).has_odometry);
}

TEST(RunLog, SkipsAndEndsByScans)
{
    RunLimits limits;
    limits.skip_scans = 4;
    limits.first_scans = 3;
    const auto outcome = run_of(MemoryLog(drive(12)), limits);
    EXPECT_EQ(outcome.run.end, RunEnd::Limit);
    EXPECT_EQ(outcome.run.scans_skipped, 4u);
    ASSERT_EQ(outcome.reports.size(), 3u);
    EXPECT_NEAR(outcome.reports[0].stamp_s, drive_start_s + 4 * drive_step_s, 1e-6);
}

TEST(RunLog, EndsWhenAskedTo)
{
    const auto outcome = run_of(MemoryLog(drive(12)), {}, 5);
    EXPECT_EQ(outcome.run.end, RunEnd::Stopped);
    EXPECT_EQ(outcome.reports.size(), 5u);
}

TEST(RunLog, KeepsWhatComesBeforeDamage)
{
    const auto outcome = run_of(MemoryLog(drive(5), true));
    EXPECT_EQ(outcome.run.end, RunEnd::DamagedLog);
    EXPECT_EQ(outcome.run.damage, "a.log, entry 7: damaged. Copy it again.");
    EXPECT_EQ(outcome.reports.size(), 5u);
}

TEST(NoScansMessage, NamesTheReason)
{
    OfflineRun run;
    EXPECT_THAT(no_scans_message("a.log", run), HasSubstr("a.log: the log holds no 2D laser scan"));
    run.scans_of_other_lasers = 9;
    run.other_labels = {"FRONT", "REAR"};
    EXPECT_THAT(no_scans_message("a.log", run), HasSubstr("lasers: 'FRONT', 'REAR'"));
    run.scans_skipped = 6;
    EXPECT_THAT(no_scans_message("a.log", run), HasSubstr("only 6 scans"));
    run.end = RunEnd::Stopped;
    EXPECT_THAT(no_scans_message("a.log", run), HasSubstr("stopped before"));
    run.end = RunEnd::DamagedLog;
    run.damage = "the reader's words";
    EXPECT_EQ(no_scans_message("a.log", run), "the reader's words");
}
}  // namespace
}  // namespace rtob::test

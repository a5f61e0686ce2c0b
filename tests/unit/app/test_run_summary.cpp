// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "run/run_summary.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

/// Two scans of 0.4 ms and 20 ms, 3 m apart; one found lost.
RunSummary two_scans()
{
    RunSummary summary;
    ScanReport report;
    report.beams.used = 100;
    report.state = TrackingState::Tracking;
    report.times.align_s = 0.4e-3;
    summary.counters.add(report);
    report.state = TrackingState::Lost;
    report.pose_map_vehicle.x = 3;
    report.map_time_s = 50;
    report.times.align_s = 20e-3;
    summary.counters.add(report);
    summary.log = "a.rawlog";
    summary.total_s = 0.25;
    summary.memory_mb = 31.4;
    return summary;
}

TEST(QuotableLine, SaysScansLossTimeMemoryAndPath)
{
    EXPECT_EQ(
        quotable_line(two_scans()),
        "2 scans, 1 lost, 0.40 ms p50, 20.0 ms p99, 31 MB, 3.00 m, 0.25 s (= 200x real time)");
}

TEST(QuotableLine, ClaimsNoSpeedWhereTheLogHasNoTime)
{
    RunSummary summary;
    summary.counters.add({});
    EXPECT_THAT(quotable_line(summary), testing::Not(HasSubstr("real time")));
}

TEST(SummaryJson, HoldsEveryGroup)
{
    const auto json = nlohmann::json::parse(summary_json(two_scans()));
    EXPECT_EQ(json["version"], RTOB_VERSION);
    EXPECT_EQ(json["ended"], "at the log's end");
    EXPECT_EQ(json["input"]["log"], "a.rawlog");
    EXPECT_EQ(json["input"]["seed"], 1);
    EXPECT_EQ(json["scans"]["total"], 2);
    EXPECT_EQ(json["states"]["LOST"], 1);
    EXPECT_EQ(json["beams"]["used"], 200);
    EXPECT_EQ(json["drive"]["duration_s"], 50.0);
    EXPECT_NEAR(json["time"]["scan_max_ms"], 20, 1e-5);
    EXPECT_EQ(json["line"], quotable_line(two_scans()));
}

TEST(SummaryJson, SurvivesAFileNameThatIsNoText)
{
    auto summary = two_scans();
    summary.log = "a\xff.rawlog";
    EXPECT_TRUE(nlohmann::json::accept(summary_json(summary)));
    EXPECT_THAT(summary_text(summary), HasSubstr("a\xff.rawlog"));
}

TEST(SummaryText, SaysHowADamagedLogEndedTheRun)
{
    auto summary = two_scans();
    summary.run.end = RunEnd::DamagedLog;
    summary.run.damage = "a.rawlog, entry 3: cut";
    EXPECT_THAT(
        summary_text(summary), HasSubstr("early, by a damaged log: a.rawlog, entry 3: cut\n"));
}
}  // namespace
}  // namespace rtob::test

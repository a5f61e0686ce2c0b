// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "run/run_counters.h"

namespace rtob::test
{
namespace
{
ScanReport report_at(double x, double y, TrackingState state = TrackingState::Tracking)
{
    ScanReport report;
    report.pose_map_vehicle = {x, y, 0};
    report.state = state;
    report.verdict = FitVerdict::Good;
    report.pairs = 100;
    report.beams.used = 180;
    return report;
}

TEST(FateOf, NamesEachKindOfScan)
{
    ScanReport report = report_at(0, 0);
    EXPECT_EQ(fate_of(report), ScanFate::Matched);
    report.verdict = FitVerdict::NewGround;
    EXPECT_EQ(fate_of(report), ScanFate::NewGround);
    report.verdict = FitVerdict::Weak;
    EXPECT_EQ(fate_of(report), ScanFate::WeakMatch);
    report.verdict = FitVerdict::None;
    EXPECT_EQ(fate_of(report), ScanFate::NoPair);
    report.beams.used = 0;
    EXPECT_EQ(fate_of(report), ScanFate::NoUsableBeam);
    report = report_at(0, 0);
    report.pairs = 0;  // good without a pair: only the scan that starts the map
    EXPECT_EQ(fate_of(report), ScanFate::Started);
}

TEST(RunCounters, SumThePathAndTheBeams)
{
    RunCounters counters;
    counters.add(report_at(7, 7));  // the path starts here: 0 m
    counters.add(report_at(10, 11));
    counters.add(report_at(10, 12));
    EXPECT_DOUBLE_EQ(counters.pathLength(), 6);
    EXPECT_EQ(counters.beams().used, 540u);
    EXPECT_EQ(counters.scans(), 3u);
}

TEST(RunCounters, CountHowOftenTrackingWasGivenUp)
{
    using State = TrackingState;
    RunCounters counters;
    for (const auto state :
         {State::Tracking, State::Degraded, State::Lost, State::Lost, State::Relocalising,
          State::Lost, State::Tracking, State::Lost})
        counters.add(report_at(0, 0, state));
    EXPECT_EQ(counters.timesLost(), 2u) << "searching and failing is the same loss";
    EXPECT_EQ(counters.lost(), 5u);
    EXPECT_EQ(counters.in(State::Tracking), 2u);
}

TEST(RunCounters, RejectedAreTheScansThatToldNothing)
{
    RunCounters counters;
    for (const auto verdict :
         {FitVerdict::Good, FitVerdict::NewGround, FitVerdict::Weak, FitVerdict::None})
    {
        auto report = report_at(0, 0);
        report.verdict = verdict;
        counters.add(report);
    }
    EXPECT_EQ(counters.rejected(), 2u);
}

TEST(RunCounters, ScanTimesAreTheSumOfTheSteps)
{
    auto report = report_at(0, 0);
    report.times.filter_s = 0.001;
    report.times.align_s = 0.002;
    RunCounters counters;
    counters.add(report);
    EXPECT_FLOAT_EQ(counters.scanTimes().at(0), 3.0f);
}
}  // namespace
}  // namespace rtob::test

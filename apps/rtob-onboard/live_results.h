// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "autopilot_thread.h"
#include "capture.h"
#include "guarded_pilot.h"
#include "localiser.h"
#include "onboard_config.h"
#include "run/output_folder.h"
#include "run/run_counters.h"
#include "run/scan_files.h"
#include "run/sensor_figures.h"
#include "sensor_runner.h"

namespace rtob
{
/// All that the summary of a live run tells.
struct LiveSummary
{
    std::string folder;
    RunCounters counters;
    TrackingState final_state = TrackingState::Init;
    std::uint64_t dropped_scans = 0;
    std::vector<float> latencies_ms;  ///< from a scan's last beam to its pose
    double run_s = 0, cpu_s = 0, memory_mb = 0;
    std::size_t map_points = 0, map_scans = 0;
    Capture::State capture;
    AutopilotThread::Report autopilot;
    std::optional<GuardedPilot::Report> pilot;  ///< where the guard was on
    std::vector<SensorReport> sensors;
    std::vector<SensorFigures> fusion;  ///< what became of their readings
    std::vector<std::string> problems;  ///< with the results themselves
};

[[nodiscard]] std::string live_summary_json(const LiveSummary& summary);
/// A line that a person can quote.
[[nodiscard]] std::string live_line(const LiveSummary& summary);

/// output_folder/20260131_142501, with a number behind it where that is there already: the clocks
/// of small computers begin anew with each start. Throws std::runtime_error.
[[nodiscard]] std::string make_flight_folder(const std::string& output_folder);

/// Writes trajectory, map, options and summary, each as far as it goes: what fails is told in
/// `summary.problems` and keeps nothing else back.
void write_live_results(
    const OutputFolder& folder, const OnboardConfig& config, const Localiser& localiser,
    ScanFiles& scan_files, LiveSummary& summary);
}  // namespace rtob

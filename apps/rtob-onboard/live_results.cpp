// SPDX-License-Identifier: BSD-3-Clause
#include "live_results.h"

#include <rtob/core/enum_names.h>
#include <rtob/core/spread.h>
#include <rtob/map/options_io.h>

#include <array>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "run/map_files.h"

namespace rtob
{
namespace
{
using Json = nlohmann::ordered_json;

Json sensors_json(const std::vector<SensorReport>& sensors)
{
    Json list = Json::array();
    for (const auto& sensor : sensors)
        list.push_back(
            {{"section", sensor.name},
             {"driver", sensor.driver},
             {"device", sensor.device},
             {"observations", sensor.observations},
             {"restarts", sensor.restarts},
             {"last_problem", sensor.problem}});
    return list;
}

Json fusion_json(const std::vector<SensorFigures>& sensors)
{
    Json fusion = Json::object();
    for (const auto& figures : sensors)
        fusion[std::string(name_of(figures.sensor))] = sensor_json(figures);
    return fusion;
}

Json scans_json(const LiveSummary& summary)
{
    Json scans{
        {"localised", summary.counters.scans()},
        {"dropped", summary.dropped_scans},
        {"rejected", summary.counters.rejected()}};
    for (const auto& [state, name] : enum_names(TrackingState{}))
        scans[std::string(name)] = summary.counters.in(state);
    scans["final_state"] = std::string(name_of(summary.final_state));
    return scans;
}

Json latency_json(const LiveSummary& summary)
{
    const auto& ms = summary.latencies_ms;
    const auto& compute = summary.counters.scanTimes();
    return {
        {"p50_ms", percentile(ms, 0.5)},
        {"p99_ms", percentile(ms, 0.99)},
        {"max_ms", percentile(ms, 1)},
        {"compute_p50_ms", percentile(compute, 0.5)},
        {"compute_p99_ms", percentile(compute, 0.99)}};
}

Json guard_json(const GuardedPilot::Report& report)
{
    Json guard{{"decisions", report.decisions}};
    for (const auto& [reason, name] : enum_names(GuardReason{}))
        guard[std::string(name)] = report.reasons[static_cast<std::size_t>(reason)];
    guard["stalls"] = report.stalls;
    guard["slowest_decision_ms"] = report.slowest_decision_ms;
    return guard;
}

void write_configs(const OutputFolder& folder, const OnboardConfig& config)
{
    AtomicFile replay(folder.file("config.effective.ini"));
    replay.stream() << "# rtob-slam run CAPTURE -c this file: the same poses again.\n\n";
    save_run_config(replay.stream(), config.run);
    replay.commit();
    AtomicFile own(folder.file("onboard.effective.ini"));
    OnboardConfig::sections(
        config,
        [&](const char* section, const auto& options)
        {
            save_options(own.stream(), section, options);
            own.stream() << "\n";
        });
    own.commit();
}
}  // namespace

std::string live_summary_json(const LiveSummary& summary)
{
    Json json{{"version", RTOB_VERSION}, {"folder", summary.folder}};
    json["scans"] = scans_json(summary);
    json["latency"] = latency_json(summary);
    json["run_s"] = summary.run_s;
    json["cpu_share"] = summary.run_s > 0 ? summary.cpu_s / summary.run_s : 0.0;
    json["peak_memory_mb"] = summary.memory_mb;
    json["path_m"] = summary.counters.pathLength();
    json["map"] = {{"scans", summary.map_scans}, {"points", summary.map_points}};
    json["capture"] = {
        {"files", summary.capture.files},
        {"objects", summary.capture.objects},
        {"bytes", summary.capture.bytes},
        {"left_out", summary.capture.left_out},
        {"problem", summary.capture.problem}};
    if (summary.pilot) json["guard"] = guard_json(*summary.pilot);
    const auto& autopilot = summary.autopilot;
    json["autopilot"] = {
        {"poses_sent", autopilot.poses_sent},
        {"frames_received", autopilot.counters.frames},
        {"frames_damaged", autopilot.counters.damaged},
        {"frames_unknown", autopilot.counters.unknown},
        {"problem", autopilot.problem}};
    json["sensors"] = sensors_json(summary.sensors);
    json["fusion"] = fusion_json(summary.fusion);
    json["problems"] = summary.problems;
    json["line"] = live_line(summary);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string live_line(const LiveSummary& summary)
{
    std::array<char, 256> text{};
    const auto& ms = summary.latencies_ms;
    std::snprintf(
        text.data(), text.size(),
        "%zu scans localised, %zu dropped, %zu lost; latency %.1f ms p50, %.1f p99, %.1f max; "
        "%.1f m in %.0f s; %.0f %% CPU, %.0f MB; captured %.1f MB",
        static_cast<std::size_t>(summary.counters.scans()),
        static_cast<std::size_t>(summary.dropped_scans),
        static_cast<std::size_t>(summary.counters.lost()), percentile(ms, 0.5),
        percentile(ms, 0.99), percentile(ms, 1), summary.counters.pathLength(), summary.run_s,
        summary.run_s > 0 ? 100 * summary.cpu_s / summary.run_s : 0.0, summary.memory_mb,
        1e-6 * static_cast<double>(summary.capture.bytes));
    return text.data();
}

std::string make_flight_folder(const std::string& output_folder)
{
    namespace fs = std::filesystem;
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::array<char, 32> name{};
    std::strftime(name.data(), name.size(), "%Y%m%d_%H%M%S", &utc);
    const fs::path base = fs::path(output_folder) / name.data();
    std::error_code error;
    fs::create_directories(output_folder, error);
    fs::path folder = base;
    for (int number = 2; !error && !fs::create_directory(folder, error); ++number)
        folder = base.string() + "_" + std::to_string(number);
    if (!error) return folder.string();
    throw std::runtime_error(
        "output folder " + folder.string() + " cannot be made: " + error.message() +
        ". Name another one: section [Onboard], key output_folder.");
}

void write_live_results(
    const OutputFolder& folder, const OnboardConfig& config, const Localiser& localiser,
    ScanFiles& scan_files, LiveSummary& summary)
{
    const auto attempt = [&](const std::function<void()>& write)
    {
        try
        {
            write();
        }
        catch (const std::exception& error)
        {
            summary.problems.emplace_back(error.what());
        }
    };
    attempt([&] { scan_files.commit(); });
    attempt([&] { write_configs(folder, config); });
    attempt(
        [&]
        {
            write_map_data(
                folder, {localiser.slam().map(),
                         localiser.mountsOfMap(),
                         {},
                         config.run.run.map_resolution_m,
                         "",
                         !config.run.slam.map.localize});
        });
    attempt([&] { write_text(folder.file("summary.json"), live_summary_json(summary)); });
    attempt([&] { write_text(folder.file("summary.txt"), live_line(summary) + "\n"); });
}
}  // namespace rtob

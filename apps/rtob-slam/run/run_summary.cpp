// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_summary.h"

#include <rtob/core/enum_names.h>
#include <rtob/core/spread.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace rtob
{
namespace
{
using Json = nlohmann::ordered_json;

std::string number(double value, int decimals)
{
    char text[400];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

/// Two digits after the point for what is below 10, one below 100, none above.
std::string brief(double value)
{
    return number(value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0);
}

double real_time_factor(const RunSummary& summary)
{
    return summary.total_s > 0 ? summary.counters.logTime() / summary.total_s : 0;
}

Json scans_json(const RunCounters& counters)
{
    Json scans{{"total", counters.scans()}, {"used", counters.scans() - counters.rejected()}};
    scans["rejected"] = counters.rejected();
    for (const auto& [fate, name] : enum_names(ScanFate{}))
        scans[std::string(name)] = counters.with(fate);
    scans["written_to_map"] = counters.inserted();
    scans["anchored"] = counters.anchored();
    scans["searched"] = counters.searched();
    scans["held_by_guess"] = counters.heldByGuess();
    return scans;
}

Json states_json(const RunSummary& summary)
{
    Json states;
    for (const auto& [state, name] : enum_names(TrackingState{}))
        states[std::string(name)] = summary.counters.in(state);
    states["times_lost"] = summary.counters.timesLost();
    states["final"] = std::string(name_of(summary.final_state));
    return states;
}

Json beams_json(const BeamCounts& beams)
{
    return {
        {"used", beams.used},
        {"invalid", beams.invalid},
        {"not_a_number", beams.not_a_number},
        {"not_positive", beams.not_positive},
        {"too_near", beams.too_near},
        {"too_far", beams.too_far},
        {"masked", beams.masked},
        {"thinned", beams.thinned},
        {"floor_or_ceiling", beams.floor_or_ceiling}};
}

Json guard_json(const GuardCounts& counts)
{
    Json guard{{"decisions", counts.decisions}};
    for (const auto& [reason, name] : enum_names(GuardReason{}))
        guard[std::string(name)] = counts.reasons[static_cast<std::size_t>(reason)];
    guard["wished_m"] = counts.wished_m;
    guard["commanded_m"] = counts.commanded_m;
    guard["slowest_decision_ms"] = counts.slowest_decision_ms;
    return guard;
}

Json times_json(const RunSummary& summary)
{
    const auto& ms = summary.counters.scanTimes();
    return {{"scan_p50_ms", percentile(ms, 0.50)},     {"scan_p95_ms", percentile(ms, 0.95)},
            {"scan_p99_ms", percentile(ms, 0.99)},     {"scan_max_ms", percentile(ms, 1.00)},
            {"matching_s", summary.matching_s},        {"total_s", summary.total_s},
            {"x_real_time", real_time_factor(summary)}};
}

/// What the run was given.
Json input_json(const RunSummary& summary)
{
    const auto& limits = summary.limits;
    Json input{{"log", summary.log}};
    input["config"] = summary.config_file.empty() ? "none" : summary.config_file;
    input["seed"] = summary.config.run.seed;
    input["density"] = std::string(name_of(summary.config.slam.density.density));
    input["odometry_used"] = summary.has_odometry;
    input["skip_scans"] = limits.skip_scans;
    if (limits.first_scans != RunLimits{}.first_scans) input["first_scans"] = limits.first_scans;
    return input;
}

/// The summary as groups of figures; both files are made from it.
Json groups_of(const RunSummary& summary)
{
    const auto& clock = summary.clock;
    Json groups;
    groups["version"] = RTOB_VERSION;
    groups["ended"] = end_text(summary.run);
    groups["input"] = input_json(summary);
    groups["scans"] = scans_json(summary.counters);
    groups["scans"]["of_other_lasers"] = summary.run.scans_of_other_lasers;
    groups["scans"]["dropped_live"] = summary.run.dropped_live;
    groups["states"] = states_json(summary);
    groups["beams"] = beams_json(summary.counters.beams());
    groups["stamps"] = {
        {"steps_back", clock.steps_back},
        {"repeats", clock.repeats},
        {"jumps", clock.jumps},
        {"invalid", clock.invalid}};
    for (const auto& figures : summary.sensors)
        groups["sensor " + std::string(name_of(figures.sensor))] = sensor_json(figures);
    groups["drive"] = {
        {"path_m", summary.counters.pathLength()}, {"duration_s", summary.counters.logTime()}};
    groups["map"] = {
        {"scans", summary.map_scans},
        {"points", summary.map_points},
        {"in_use_mb", static_cast<double>(summary.map_bytes) / 1e6},
        {"picture_resolution_m", summary.map_resolution_m},
        {"checksum", summary.map_checksum}};
    if (const auto& map = summary.config.slam.map; !map.file.empty())
        groups["map"].update(
            {{"from_file", map.file},
             {"checksum_before", summary.map_checksum_before},
             {"localised_only", map.localize}});
    if (summary.guard) groups["guard"] = guard_json(*summary.guard);
    groups["time"] = times_json(summary);
    groups["memory"] = {
        {"peak_until_last_scan_mb", summary.matching_memory_mb}, {"peak_mb", summary.memory_mb}};
    return groups;
}

std::string value_text(const Json& value)
{
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    return value.is_number_float() ? number(value.get<double>(), 3) : value.dump();
}

void add_line(std::string& text, const std::string& name, const Json& value)
{
    constexpr std::size_t column = 28;
    text += name + std::string(column - std::min(column - 1, name.size()), ' ');
    text += value_text(value) + "\n";
}
}  // namespace

std::string end_text(const OfflineRun& run)
{
    switch (run.end)
    {
        case RunEnd::LogEnd:
            return "at the log's end";
        case RunEnd::Limit:
            return "after as many scans as --first said";
        case RunEnd::Stopped:
            return "early, by a signal";
        case RunEnd::DamagedLog:
            return "early, by a damaged log: " + run.damage;
    }
    throw std::logic_error("end_text: unknown value");
}

std::string quotable_line(const RunSummary& summary)
{
    const auto& counters = summary.counters;
    const auto& ms = counters.scanTimes();
    std::string line = std::to_string(counters.scans()) + " scans, " +
                       std::to_string(counters.lost()) + " lost, " + brief(percentile(ms, 0.5)) +
                       " ms p50, " + brief(percentile(ms, 0.99)) + " ms p99, " +
                       number(summary.memory_mb, 0) + " MB, " + brief(counters.pathLength()) +
                       " m, " + brief(summary.total_s) + " s";
    if (counters.logTime() > 0)
        line += " (= " + number(real_time_factor(summary), 0) + "x real time)";
    return line;
}

std::string summary_text(const RunSummary& summary)
{
    const Json groups = groups_of(summary);
    std::string text;
    for (const auto& [group, content] : groups.items())
    {
        if (!content.is_object())
        {
            add_line(text, group, content);
            continue;
        }
        text += "\n" + group + "\n";
        for (const auto& [key, value] : content.items()) add_line(text, "  " + key, value);
    }
    return text + "\n" + quotable_line(summary) + "\n";
}

std::string summary_json(const RunSummary& summary)
{
    Json json = groups_of(summary);
    json["line"] = quotable_line(summary);
    // Paths need not be UTF-8; a summary must not fail over them.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}
}  // namespace rtob

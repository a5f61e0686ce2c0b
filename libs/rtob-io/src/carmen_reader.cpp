// SPDX-License-Identifier: BSD-3-Clause
#include "carmen_reader.h"

#include <algorithm>

#include "carmen_observations.h"

namespace rtob
{
namespace
{
/// CARMEN's message names are upper case: FLASER, ODOM, NMEA-GGA, ROBOTLASER1 ...
bool is_message_name(std::string_view word)
{
    return std::all_of(
        word.begin(), word.end(),
        [](char c)
        { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-'; });
}
}  // namespace

CarmenReader::CarmenReader(const std::string& file)
    : file_(file), survey_(survey_carmen_log(file)), lines_(file)
{
}

std::optional<LogEntry> CarmenReader::next()
{
    if (waiting_scan_) return LogEntry{std::move(waiting_scan_), nullptr};
    try
    {
        while (const auto line = lines_.next())
            if (auto entry = read_line(*line)) return entry;
        return std::nullopt;
    }
    catch (const ByteSourceError& error)
    {
        throw line_error(error.what(), error.fix());
    }
    catch (const FieldError& error)
    {
        if (lines_.line_is_open())
            throw line_error(
                std::string("the log is truncated in its last line: ") + error.what(),
                "Copy the log again, or delete this line to use the rest");
        throw line_error(error.what(), "Correct or delete this line");
    }
}

std::optional<LogEntry> CarmenReader::read_line(std::string_view line)
{
    TextFields fields(line);
    const auto name = fields.next_word();
    if (name.empty() || name.front() == '#') return std::nullopt;
    if (laser_of_line(name, scan_.laser)) return read_scan(fields);
    if (name == "ODOM")
    {
        const auto odometry = parse_odom(fields);
        if (survey_.lasers_carry_odometry)
        {
            ++losses_["ODOM lines: the laser lines carry the odometry"];
            return std::nullopt;
        }
        return LogEntry{to_observation(odometry), nullptr};
    }
    if (!is_message_name(name))
        throw FieldError(
            "'" + std::string(name.substr(0, 40)) +
            "' stands where the name of a CARMEN message (FLASER, ODOM, ...) was expected");
    // Every message carries something, at least its stamp: a bare name is a cut line.
    static_cast<void>(fields.word("a message's content"));
    ++losses_
        [std::string(name) + (name == "PARAM" ? " lines: only laser mounts are taken from them"
                                              : " lines: not of a laser or its odometry")];
    return std::nullopt;
}

std::optional<LogEntry> CarmenReader::read_scan(TextFields& fields)
{
    parse_scan(fields, scan_);
    if (scan_.lost_remissions > 0)
        losses_["remissions that are not whole numbers, one a beam"] += scan_.lost_remissions;
    if (survey_.is_corrected)
        ++losses_["laser poses in another frame than the odometry, as in corrected logs"];
    const auto& pose_vehicle_laser =
        survey_.poses_vehicle_laser[static_cast<std::size_t>(scan_.laser)];
    auto scan = to_observation(scan_, pose_vehicle_laser);
    if (!survey_.lasers_carry_odometry) return LogEntry{scan, nullptr};
    waiting_scan_ = scan;
    return LogEntry{
        to_observation(CarmenOdometry{scan_.pose_odom_vehicle, scan_.stamp_100ns}), nullptr};
}

LogError CarmenReader::line_error(const std::string& problem, const std::string& fix) const
{
    return {file_, "line " + std::to_string(lines_.line_number()), problem, fix};
}
}  // namespace rtob

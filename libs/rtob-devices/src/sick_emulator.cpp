// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/devices/sick_emulator.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rtob::devices
{
namespace
{
constexpr char kBegin = 0x02, kEnd = 0x03;
constexpr double kFirst_deg = -135;  // seen from its front
constexpr double kPi = 3.14159265358979323846;

std::string hex(unsigned value)
{
    char text[16];
    std::snprintf(text, sizeof text, "%X", value);
    return text;
}

std::string hex_of(double value)
{
    return hex(static_cast<unsigned>(std::lround(value)));
}

bool begins_with(const std::string& text, const char* start)
{
    return text.rfind(start, 0) == 0;
}
}  // namespace

SickModel model_tim561()
{
    return {"TiM561-2050101", 811, 1.0 / 3, 1.0 / 15, 10};
}

SickModel model_lms111()
{
    return {"LMS111-10100", 1081, 0.25, 1.0 / 25, 20};
}

SickEmulator::SickEmulator(RangeSource ranges, SickModel model)
    : ranges_(std::move(ranges)), model_(std::move(model))
{
}

void SickEmulator::restart()
{
    received_.clear();
    replies_.clear();
    ranges_text_.clear();
    sends_each_scan_ = false;
    next_scan_s_ = 0;
}

void SickEmulator::breakDown()
{
    sends_each_scan_ = false;
    has_error_ = true;
}

void SickEmulator::receive(const Packet& bytes, double now_s)
{
    received_.append(bytes.begin(), bytes.end());
    for (auto end = received_.find(kEnd); end != std::string::npos; end = received_.find(kEnd))
    {
        const auto begin = received_.rfind(kBegin, end);
        if (begin != std::string::npos) answer(received_.substr(begin + 1, end - begin - 1), now_s);
        received_.erase(0, end + 1);
    }
}

void SickEmulator::answer(const std::string& command, double now_s)
{
    measure(now_s);
    if (begins_with(command, "sEN LMDscandata"))
    {
        has_error_ = false;
        sends_each_scan_ = command.back() == '1';
        reply("sEA LMDscandata " + std::string(sends_each_scan_ ? "1" : "0"));
    }
    else if (has_error_ && command == "sRN LMDscandata")
        reply("sFA 6");
    else if (command == "sRN LMDscandata")
        reply("sRA " + scanData());
    else if (command == "sRN SCdevicestate")
        reply("sRA SCdevicestate " + std::string(has_error_ ? "2" : "1"));
    else if (command == "sRN STlms")
        reply(has_error_ ? "sRA STlms 2" : "sRA STlms 7");  // 7: it measures
    else if (command == "sRIO")
        reply("sRA 0 " + model_.name + " V1.0 emulated");
    else if (begins_with(command, "sRN "))
        reply("sRA " + command.substr(4) + " 8 emulated");
    else if (begins_with(command, "sWN "))
        reply("sWA " + command.substr(4, command.find(' ', 4) - 4));
    else if (begins_with(command, "sMN "))
    {
        has_error_ &= command != "sMN LMCstartmeas";
        reply("sAN " + command.substr(4, command.find(' ', 4) - 4) + " 1");
    }
    else
        reply("sFA 1");
}

void SickEmulator::measure(double now_s)
{
    if (next_scan_s_ == 0) next_scan_s_ = now_s - model_.turn_s;
    // What a late caller missed is measured no more.
    next_scan_s_ = std::max(next_scan_s_, now_s - 4 * model_.turn_s);
    while (now_s >= next_scan_s_ + model_.turn_s)
    {
        ranges_text_.clear();
        for (int beam = 0; beam < model_.beams; ++beam)
        {
            const double bearing_deg = kFirst_deg + model_.step_deg * beam;
            const double time_s = next_scan_s_ + model_.turn_s * model_.step_deg * beam / 360;
            const double range_m = ranges_(bearing_deg * kPi / 180, time_s);
            const bool is_seen = range_m > 0 && range_m < model_.max_range_m;
            ranges_text_ +=
                " " + hex(is_seen ? static_cast<unsigned>(std::lround(1000 * range_m)) : 0U);
        }
        ++scans_;
        if (sends_each_scan_) reply("sSN " + scanData());
        next_scan_s_ += model_.turn_s;
    }
}

/// Version, device, serial number, status, counters, two times, inputs, outputs, rates, no encoder,
/// one channel: distances in mm, from -45 degrees on (the right is 0 there), step and number.
std::string SickEmulator::scanData() const
{
    return "LMDscandata 1 1 A89A7F 0 0 " + hex(scans_) + " " + hex(scans_) + " 0 0 0 0 0 0 0 " +
           hex_of(100 / model_.turn_s) + " A2 0 1 DIST1 3F800000 00000000 FFF92230 " +
           hex_of(10000 * model_.step_deg) + " " + hex_of(model_.beams) + ranges_text_ +
           " 0 0 0 0 0 0";
}

std::vector<Packet> SickEmulator::send(double now_s)
{
    if (sends_each_scan_) measure(now_s);
    std::vector<Packet> packets = std::move(replies_);
    replies_.clear();
    return packets;
}

void SickEmulator::reply(const std::string& telegram)
{
    const std::string framed = kBegin + telegram + kEnd;
    replies_.emplace_back(framed.begin(), framed.end());
}
}  // namespace rtob::devices

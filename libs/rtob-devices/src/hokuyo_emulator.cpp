// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/devices/hokuyo_emulator.h>

#include <algorithm>
#include <cmath>

namespace rtob::devices
{
namespace
{
constexpr int kSteps = 1440, kFirst = 0, kLast = 1080, kFront = 540;
constexpr int kClockLetters = 4;  // 24 bits
constexpr double kTurn_s = 0.025, kMaxRange_m = 30;
constexpr double kPi = 3.14159265358979323846;

/// The check letter behind each line.
char sum_of(const std::string& text)
{
    unsigned sum = 0;
    for (const char letter : text) sum += static_cast<unsigned char>(letter);
    return static_cast<char>((sum & 0x3F) + 0x30);
}

std::string line(const std::string& text, const std::string& end = "")
{
    return text + end + sum_of(text) + "\n";
}

/// Six bits a letter; what does not fit is cut off.
std::string encoded(unsigned value, int letters)
{
    std::string text;
    for (int i = letters - 1; i >= 0; --i)
        text += static_cast<char>(((value >> (6 * i)) & 0x3F) + 0x30);
    return text;
}

Packet bytes_of(const std::string& text)
{
    return {text.begin(), text.end()};
}
}  // namespace

HokuyoEmulator::HokuyoEmulator(RangeSource ranges, unsigned clock_ms)
    : ranges_(std::move(ranges)), clock_at_power_ms_(clock_ms)
{
}

void HokuyoEmulator::restart()
{
    power_s_.reset();
    received_.clear();
    replies_.clear();
    scan_command_.clear();
}

void HokuyoEmulator::receive(const Packet& bytes, double now_s)
{
    if (!power_s_) power_s_ = now_s;
    received_.append(bytes.begin(), bytes.end());
    for (auto end = received_.find('\n'); end != std::string::npos; end = received_.find('\n'))
    {
        answer(received_.substr(0, end), now_s);
        received_.erase(0, end + 1);
    }
}

void HokuyoEmulator::answer(const std::string& command, double now_s)
{
    const std::string kind = command.substr(0, 2);
    if (kind == "QT" || kind == "RS") scan_command_.clear();
    if (kind == "BM" || kind == "RS") has_error_ = false;
    std::string data;
    if (kind == "PP")
        for (const char* text :
             {"MODL:UTM-30LX", "DMIN:23", "DMAX:30000", "ARES:1440", "AMIN:0", "AMAX:1080",
              "AFRT:540", "SCAN:2400"})
            data += line(text, ";");
    if (kind == "VV")
        for (const char* text : {"VEND:emulated", "PROD:UTM-30LX", "FIRM:1", "PROT:SCIP 2.0"})
            data += line(text, ";");
    replies_.push_back(bytes_of(command + "\n" + line("00") + data + "\n"));
    if (kind != "MD") return;
    scan_command_ = command;
    next_scan_s_ = now_s;
}

std::vector<Packet> HokuyoEmulator::send(double now_s)
{
    std::vector<Packet> packets = std::move(replies_);
    replies_.clear();
    while (!scan_command_.empty() && now_s >= next_scan_s_ + kTurn_s)
    {
        // What a late caller missed is measured no more.
        next_scan_s_ = std::max(next_scan_s_, now_s - 4 * kTurn_s);
        packets.push_back(
            bytes_of(has_error_ ? scan_command_ + "\n" + line("50") + "\n" : scan(next_scan_s_)));
        next_scan_s_ += kTurn_s;
    }
    return packets;
}

std::string HokuyoEmulator::scan(double start_s) const
{
    constexpr std::size_t line_letters = 64;
    const double clock_ms = clock_at_power_ms_ + 1000 * (start_s - *power_s_);
    std::string ranges;
    for (int step = kFirst; step <= kLast; ++step)
    {
        const double time_s = start_s + kTurn_s * step / kSteps;
        const double range_m = ranges_(2 * kPi * (step - kFront) / kSteps, time_s);
        const bool is_seen = range_m > 0 && range_m < kMaxRange_m;
        ranges += encoded(is_seen ? static_cast<unsigned>(std::lround(1000 * range_m)) : 1U, 3);
    }
    std::string text = scan_command_ + "\n" + line("99") +
                       line(encoded(static_cast<unsigned>(clock_ms), kClockLetters));
    for (std::size_t at = 0; at < ranges.size(); at += line_letters)
        text += line(ranges.substr(at, line_letters));
    return text + "\n";
}
}  // namespace rtob::devices

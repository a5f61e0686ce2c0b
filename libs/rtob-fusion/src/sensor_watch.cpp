// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/enum_names.h>
#include <rtob/fusion/sensor_watch.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace rtob
{
namespace
{
constexpr double kFarAhead_s = 2;      // of all others: no sensor knows the future
constexpr int kStuckAfter = 50;        // equal readings; noise moves the last digit of live sensors
constexpr double kShortSilence_s = 1;  // is not worth a word
constexpr double kShortLag_s = 0.2;

std::string with_number(const char* format, double value)
{
    char text[100];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string share_text(std::uint64_t count, std::uint64_t all, const char* what)
{
    return std::to_string(count) + " of " + std::to_string(all) + " readings " + what;
}
}  // namespace

ReadingFate SensorWatch::judge(const Measurement& reading, double newest_s)
{
    if (!is_finite(reading)) return ReadingFate::NotFinite;
    if (!has_positive_covariance(reading)) return ReadingFate::BadCovariance;
    if (reading.time_s < last_s_) return ReadingFate::StampBack;
    if (reading.time_s == last_s_) return ReadingFate::StampRepeated;
    if (reading.time_s > newest_s + kFarAhead_s) return ReadingFate::StampAhead;
    // A vehicle at rest tells zeros, wheels do so exactly, and stays at its pose.
    const bool is_same = reading.value == last_value_ && !reading.value.isZero() &&
                         reading.kind != Measurement::Kind::WayBegin;
    same_in_a_row_ = is_same ? same_in_a_row_ + 1 : 0;
    last_value_ = reading.value;
    return same_in_a_row_ >= kStuckAfter ? ReadingFate::Stuck : ReadingFate::Used;
}

ReadingFate SensorWatch::admit(const Measurement& reading, double newest_s)
{
    const ReadingFate fate = judge(reading, newest_s);
    if (fate != ReadingFate::Used)
    {
        refused(fate);
        return fate;
    }
    if (std::isnan(last_s_))
        first_s_ = reading.time_s, admitted_ = 0;
    else
        longest_gap_s_ = std::max(longest_gap_s_, reading.time_s - last_s_);
    last_s_ = reading.time_s;
    ++admitted_;
    if (newest_s > reading.time_s) lag_sum_s_ += newest_s - reading.time_s;
    ++lags_;
    return fate;
}

void SensorWatch::took(const Innovation& innovation)
{
    refused(innovation.used ? ReadingFate::Used : ReadingFate::Gated);
    nis_sum_ += innovation.nis;
    freedom_sum_ += static_cast<std::uint64_t>(innovation.freedom);
}

std::uint64_t SensorWatch::readings() const
{
    return std::accumulate(fates_.begin(), fates_.end(), std::uint64_t{0});
}

double SensorWatch::meanLag() const
{
    return lags_ > 0 ? lag_sum_s_ / static_cast<double>(lags_) : 0;
}

double SensorWatch::meanNis() const
{
    return freedom_sum_ > 0 ? nis_sum_ / static_cast<double>(freedom_sum_) : 0;
}

/// A slow sensor may be quiet for longer than a fast one.
double SensorWatch::silenceToName() const
{
    constexpr double missed = 5;
    const double usual_s =
        admitted_ > 1 ? (last_s_ - first_s_) / static_cast<double>(admitted_ - 1) : 0;
    return std::max(kShortSilence_s, missed * usual_s);
}

bool SensorWatch::isSilent(double now_s) const
{
    return now_s - last_s_ > silenceToName();
}

std::string SensorWatch::complaint(double now_s) const
{
    std::string text;
    const auto add = [&](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
    const std::uint64_t all = readings();
    if (isSilent(now_s))
        add(with_number("silent for the last %.1f s", now_s - last_s_));
    else if (longest_gap_s_ > silenceToName())
        add(with_number("was silent for %.1f s", longest_gap_s_));
    if (meanLag() > kShortLag_s) add(with_number("late by %.2f s", meanLag()));
    constexpr std::array<std::pair<ReadingFate, const char*>, 8> words{
        {{ReadingFate::NotFinite, "are no numbers"},
         {ReadingFate::BadCovariance, "have a covariance that is not positive"},
         {ReadingFate::StampBack, "step back in time"},
         {ReadingFate::StampRepeated, "repeat a stamp"},
         {ReadingFate::StampAhead, "are stamped ahead of all other sensors"},
         {ReadingFate::TooLate, "came too late"},
         {ReadingFate::Implausible, "are impossible"},
         {ReadingFate::Stuck, "are stuck at one value"}}};
    for (const auto& [fate, what] : words)
        if (with(fate) > 0) add(share_text(with(fate), all, what));
    constexpr double many = 0.05;  // of readings; few are refused in every turn of a real vehicle
    if (static_cast<double>(with(ReadingFate::Gated)) > many * static_cast<double>(all))
        add(share_text(with(ReadingFate::Gated), all, "contradict the other sensors"));
    return text;
}
}  // namespace rtob

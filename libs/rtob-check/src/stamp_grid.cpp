// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/stamp_grid.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "figures.h"

namespace rtob
{
namespace
{
constexpr std::size_t kFewest = 100, kMost = 200000;
constexpr double kEqual_s = 5e-6;  // what stamps of six decimals and MRPT's clock leave of equality
constexpr double kComputed = 0.5;  // share of equal intervals

struct Commonest
{
    double interval_s = 0, share = 0;
};

/// The interval that most others equal.
Commonest commonest(std::vector<double> intervals_s)
{
    std::sort(intervals_s.begin(), intervals_s.end());
    std::size_t begin = 0, best_begin = 0, best_count = 0;
    for (std::size_t end = 0; end < intervals_s.size(); ++end)
    {
        while (intervals_s[end] - intervals_s[begin] > 2 * kEqual_s) ++begin;
        if (end + 1 - begin <= best_count) continue;
        best_count = end + 1 - begin;
        best_begin = begin;
    }
    return {
        intervals_s[best_begin + best_count / 2],
        static_cast<double>(best_count) / static_cast<double>(intervals_s.size())};
}

/// Sensors with a clock of their own and stamps of whole milliseconds repeat intervals, too.
bool is_whole_milliseconds(double interval_s)
{
    const double interval_ms = 1e3 * interval_s;
    return std::abs(interval_ms - std::round(interval_ms)) < 1e3 * 2 * kEqual_s;
}
}  // namespace

void StampGrid::add(double stamp_s)
{
    if (!std::isfinite(stamp_s)) return;
    const auto last_s = std::exchange(last_s_, stamp_s);
    if (last_s && stamp_s > *last_s && intervals_s_.size() < kMost)
        intervals_s_.push_back(stamp_s - *last_s);
}

void StampGrid::report(CheckReport& report) const
{
    if (intervals_s_.size() < kFewest) return;
    const auto [interval_s, share] = commonest(intervals_s_);
    Finding finding;
    finding.id = "stamps.origin";
    finding.values = {{"commonest_interval_s", interval_s}, {"share", share}};
    finding.text = "the intervals vary as those of measured stamps do, or are whole milliseconds";
    if (share > kComputed && !is_whole_milliseconds(interval_s))
    {
        finding.severity = Severity::Warn;
        finding.text =
            percent(share) + " of the intervals are " + fixed(interval_s, 6) +
            " s to the microsecond: the stamps were computed from the rate, not measured";
        finding.fix =
            "When each scan was taken is not known to better than an interval: judge the lag of "
            "the odometry by the laser, not by the stamps";
    }
    report.findings.push_back(std::move(finding));
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/devices/recorded_scans.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rtob::devices
{
namespace
{
constexpr double kTurn_rad = 2 * 3.14159265358979323846;

double range_at(const RecordedScan& scan, double bearing_rad)
{
    // From the first beam on, in the direction in which they follow each other.
    double offset_rad = (bearing_rad - scan.first_rad) * (scan.step_rad < 0 ? -1 : 1);
    const double half_step_rad = std::abs(scan.step_rad) / 2;
    offset_rad -= kTurn_rad * std::floor((offset_rad + half_step_rad) / kTurn_rad);
    const auto beam = static_cast<std::size_t>(
        std::floor((offset_rad + half_step_rad) / std::abs(scan.step_rad)));
    return beam < scan.ranges_m.size() ? scan.ranges_m[beam] : 0.0;
}
}  // namespace

RangeSource play_scans(std::vector<RecordedScan> scans, double begin_s)
{
    if (scans.empty()) throw std::invalid_argument("no scans to play");
    // Logs exist whose stamps step back: such a scan is seen at once.
    for (std::size_t i = 1; i < scans.size(); ++i)
        scans[i].time_s = std::max(scans[i].time_s, scans[i - 1].time_s);
    const double shift_s = begin_s - scans.front().time_s;
    return [scans = std::move(scans), shift_s](double bearing_rad, double time_s)
    {
        const auto next = std::upper_bound(
            scans.begin(), scans.end(), time_s - shift_s,
            [](double time, const RecordedScan& scan) { return time < scan.time_s; });
        return range_at(next == scans.begin() ? *next : *(next - 1), bearing_rad);
    };
}
}  // namespace rtob::devices

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "holonomic.h"

namespace rtob::fly
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

/// Ends the ways that lead to one point.
void shorten(std::vector<double>& ways_m, double distance_m, double bearing_rad, double radius_m)
{
    const auto count = static_cast<double>(ways_m.size());
    const double half_rad = distance_m > radius_m ? std::asin(radius_m / distance_m) : kPi / 2;
    const auto at = [&](double angle_rad) { return (angle_rad + kPi) * count / (2 * kPi) - 0.5; };
    const auto first = static_cast<int>(std::ceil(at(bearing_rad - half_rad)));
    const auto last = static_cast<int>(std::floor(at(bearing_rad + half_rad)));
    const auto all = static_cast<int>(ways_m.size());
    for (int i = first; i <= last; ++i)
    {
        const double off_rad = (i + 0.5) * 2 * kPi / count - kPi - bearing_rad;
        const double aside_m = distance_m * std::sin(off_rad);
        const double half_chord_m =
            std::sqrt(std::max(0.0, radius_m * radius_m - aside_m * aside_m));
        const double way_m = std::max(0.0, distance_m * std::cos(off_rad) - half_chord_m);
        double& kept_m = ways_m[static_cast<std::size_t>((i % all + all) % all)];
        kept_m = std::min(kept_m, way_m);
    }
}
}  // namespace

std::vector<double> free_ways(
    const GuardScan& scan, double radius_m, std::size_t directions, double most_m)
{
    std::vector<double> ways_m(directions, most_m);
    for (std::size_t i = 0; i < scan.beams; ++i)
    {
        const double range_m = scan.ranges_m[i];
        if (!(range_m > 0) || range_m >= scan.max_range_m || range_m > most_m + radius_m) continue;
        const double bearing_rad = scan.first_bearing_rad + static_cast<double>(i) * scan.step_rad;
        shorten(ways_m, range_m, wrap_angle(bearing_rad), radius_m);
    }
    return ways_m;
}
}  // namespace rtob::fly

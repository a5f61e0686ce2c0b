// SPDX-License-Identifier: BSD-3-Clause
#include "stamp_index.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace rtob
{
std::string stamp_text(double time_s)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.6f s", time_s);
    return text;
}

StampIndex::StampIndex(const std::vector<StampedPose2>& trajectory)
    : trajectory_(&trajectory), order_(trajectory.size())
{
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(
        order_.begin(), order_.end(),
        [&](std::size_t a, std::size_t b) { return stamp(a) < stamp(b); });
}

std::size_t StampIndex::nearestPlace(double time_s) const
{
    const auto after = firstPlaceFrom(time_s);
    if (after == 0) return 0;
    const double before_s = stampAt(after - 1);
    if (after < size() && stampAt(after) - time_s < time_s - before_s) return after;
    return firstPlaceFrom(before_s);
}

std::string StampIndex::range() const
{
    if (order_.empty()) return "no poses";
    return std::to_string(size()) + " poses from " + stamp_text(stampAt(0)) + " to " +
           stamp_text(stampAt(size() - 1));
}

std::size_t StampIndex::firstPlaceFrom(double time_s) const
{
    const auto found = std::lower_bound(
        order_.begin(), order_.end(), time_s,
        [&](std::size_t pose, double wanted_s) { return stamp(pose) < wanted_s; });
    return static_cast<std::size_t>(found - order_.begin());
}
}  // namespace rtob

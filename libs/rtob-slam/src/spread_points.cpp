// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/spread_points.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
// Beams that meet one thing are seldom farther apart; between two things there is nothing to match.
constexpr float kGap_m = 0.2f;

float step_to(const PointsView& points, std::size_t i)
{
    const float dx = points.x[i] - points.x[i - 1], dy = points.y[i] - points.y[i - 1];
    return std::min(kGap_m, std::sqrt(dx * dx + dy * dy));
}
}  // namespace

void spread_points(const PointsView& points, std::size_t most, Points& spread)
{
    spread.clear();
    const bool keep_all = points.size <= most;
    float length_m = 0;
    for (std::size_t i = 1; i < points.size && !keep_all; ++i) length_m += step_to(points, i);
    const float step_m = length_m / static_cast<float>(most);
    float way_m = step_m;  // since the last one that was kept
    for (std::size_t i = 0; i < points.size; ++i)
    {
        if (i > 0) way_m += step_to(points, i);
        if (!keep_all && (way_m < step_m || spread.size() == most)) continue;
        way_m = std::min(way_m - step_m, step_m);
        spread.add(points.x[i], points.y[i]);
    }
}
}  // namespace rtob

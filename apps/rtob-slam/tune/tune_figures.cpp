// SPDX-License-Identifier: BSD-3-Clause
#include "tune/tune_figures.h"

#include <algorithm>

namespace rtob
{
namespace
{
constexpr double as_good_share = 0.05, as_good_m = 0.0005;

/// Sec. 2.3: as many points and iterations as the computer has time for.
bool takes_the_largest(const Sweep& sweep)
{
    return sweep.name() == "Draw.points" || sweep.name() == "Icp.iterations";
}

const TunePoint* most_accurate(const std::vector<const TunePoint*>& points)
{
    return *std::min_element(
        points.begin(), points.end(),
        [](const TunePoint* a, const TunePoint* b)
        { return a->figures.worst_m < b->figures.worst_m; });
}
}  // namespace

bool is_less_accurate(const TuneFigures& one, const TuneFigures& other)
{
    return one.worst_m > std::max(other.worst_m * (1 + as_good_share), other.worst_m + as_good_m);
}

bool is_feasible(const TuneFigures& figures, double budget_ms)
{
    return figures.lost_scans == 0 && figures.p99_ms <= budget_ms;
}

std::string chosen_value(const TuneCurve& curve, double budget_ms)
{
    std::vector<const TunePoint*> feasible;
    for (const auto& point : curve.points)
        if (is_feasible(point.figures, budget_ms)) feasible.push_back(&point);
    if (feasible.empty()) return {};
    if (takes_the_largest(curve.sweep)) return feasible.back()->value;
    const TunePoint* best = most_accurate(feasible);
    for (const auto* point : feasible)
        if (point->value == curve.value_before && !is_less_accurate(point->figures, best->figures))
            return point->value;
    return best->value;
}
}  // namespace rtob

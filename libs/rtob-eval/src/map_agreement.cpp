// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/icp.h>
#include <rtob/core/neighbour_grid.h>
#include <rtob/core/wide_search.h>
#include <rtob/eval/map_agreement.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

namespace rtob
{
namespace
{
constexpr double half_turn_rad = 3.14159265358979323846;
constexpr std::size_t searched_points = 400;  // what WideSearch is made for

/// The first finite point of each cell.
Points thinned(const PointsView& points, double cell_m)
{
    std::set<std::pair<long, long>> taken;
    Points kept;
    for (std::size_t i = 0; i < points.size; ++i)
    {
        if (!std::isfinite(points.x[i]) || !std::isfinite(points.y[i])) continue;
        const auto cell = std::make_pair(
            std::lround(static_cast<double>(points.x[i]) / cell_m),
            std::lround(static_cast<double>(points.y[i]) / cell_m));
        if (taken.insert(cell).second) kept.add(points.x[i], points.y[i]);
    }
    return kept;
}

Points every_so_many(const Points& points, std::size_t most)
{
    const std::size_t step = (points.size() + most - 1) / most;
    Points chosen;
    for (std::size_t i = 0; i < points.size(); i += step) chosen.add(points.x[i], points.y[i]);
    return chosen;
}

Points moved(const Points& points, const Pose2& pose)
{
    const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
    Points result;
    result.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double x = points.x[i], y = points.y[i];
        result.add(
            static_cast<float>(pose.x + c * x - s * y), static_cast<float>(pose.y + s * x + c * y));
    }
    return result;
}

/// The whole turn and the whole window first, then ICP.
Pose2 laid_onto(const Points& estimate, const Points& reference, const MapAgreementOptions& options)
{
    WideSearch search;
    const Pose2 coarse = search
                             .search(
                                 every_so_many(estimate, searched_points).view(), reference.view(),
                                 {options.search_m, half_turn_rad})
                             .correction;
    IcpOptions icp_options;
    icp_options.iterations = 60;
    icp_options.cell_points = 0;
    icp_options.kernel_scale_m = icp_options.final_pair_distance_m = options.tolerance_m;
    icp_options.line_radius_m = 2 * options.tolerance_m;
    icp_options.max_pair_distance_m = 6 * options.tolerance_m;
    Icp icp(icp_options);
    const Pose2 correction = icp.align(moved(estimate, coarse).view(), reference.view()).correction;
    return compose(correction, coarse);
}

struct Shared
{
    double share = 0, mean_distance_m = 0;
};

Shared shared_with(const Points& points, const Points& others, double tolerance_m)
{
    NeighbourGrid grid;
    grid.build(others.view(), tolerance_m);
    std::size_t near = 0;
    double sum_m = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const auto neighbour =
            grid.nearest(points.x[i], points.y[i], static_cast<float>(tolerance_m));
        if (neighbour.index == NeighbourGrid::kNone) continue;
        ++near;
        sum_m += std::sqrt(static_cast<double>(neighbour.squared_distance));
    }
    if (near == 0) return {};
    return {
        static_cast<double>(near) / static_cast<double>(points.size()),
        sum_m / static_cast<double>(near)};
}
}  // namespace

MapAgreement map_agreement(
    const PointsView& points_estimate, const PointsView& points_reference,
    const MapAgreementOptions& options)
{
    if (!(options.cell_m > 0 && options.tolerance_m > 0 && options.search_m > 0))
        throw std::invalid_argument("map_agreement: lengths must be greater than 0");
    const Points estimate = thinned(points_estimate, options.cell_m);
    const Points reference = thinned(points_reference, options.cell_m);
    if (estimate.size() == 0 || reference.size() == 0)
        throw std::invalid_argument("map_agreement: a map holds no points");
    MapAgreement agreement;
    agreement.estimate_cells = estimate.size();
    agreement.reference_cells = reference.size();
    agreement.pose_reference_estimate = laid_onto(estimate, reference, options);
    const Points laid = moved(estimate, agreement.pose_reference_estimate);
    const Shared there = shared_with(laid, reference, options.tolerance_m);
    agreement.estimate_share = there.share;
    agreement.mean_distance_m = there.mean_distance_m;
    agreement.reference_share = shared_with(reference, laid, options.tolerance_m).share;
    return agreement;
}
}  // namespace rtob

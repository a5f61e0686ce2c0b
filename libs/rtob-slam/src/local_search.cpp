// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <rtob/core/icp.h>
#include <rtob/core/option_checks.h>
#include <rtob/slam/local_search.h>

#include <algorithm>

namespace rtob
{
void SearchOptions::validate() const
{
    require(half_width_m > 0, "half_width_m", half_width_m, "> 0");
    require(half_angle_deg > 0, "half_angle_deg", half_angle_deg, "> 0");
    require(lost_half_width_m > 0, "lost_half_width_m", lost_half_width_m, "> 0");
    require(
        lost_half_angle_deg > 0 && lost_half_angle_deg <= 180, "lost_half_angle_deg",
        lost_half_angle_deg, "in (0, 180]");
    require(
        min_paired_share > 0 && min_paired_share <= 1, "min_paired_share", min_paired_share,
        "in (0, 1]");
    require(points >= 20, "points", points, ">= 20");
}

LocalSearch::LocalSearch(const SearchOptions& options) : options_(options)
{
    options_.validate();
}

Pose2 LocalSearch::search(
    const Pose2& pose_map_guess, const Points& points_turned, const Reference& reference, bool lost,
    double max_half_width_m)
{
    const auto wanted = static_cast<std::size_t>(options_.points);
    const std::size_t stride = (points_turned.size() + wanted - 1) / wanted;
    thinned_.clear();
    for (std::size_t i = 0; i < points_turned.size(); i += stride)
        thinned_.add(points_turned.x[i], points_turned.y[i]);
    const SearchWindow window{
        std::min(max_half_width_m, lost ? options_.lost_half_width_m : options_.half_width_m),
        mrpt::DEG2RAD(lost ? options_.lost_half_angle_deg : options_.half_angle_deg)};
    const SearchResult found = search_.search(thinned_.view(), reference.points.view(), window);
    return apply_correction(pose_map_guess, found.correction);
}
}  // namespace rtob

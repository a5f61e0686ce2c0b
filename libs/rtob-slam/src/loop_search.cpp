// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/slam/loop_search.h>
#include <rtob/slam/turned_points.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
// Two searches agree when they differ by less than this, in the directions that are held.
constexpr double kAgree_m = 0.3, kAgree_rad = 0.02;
// The window where nothing drifted: ICP's own reach and a little.
constexpr double kLeastHalfWidth_m = 0.5, kLeastHalfAngle_rad = 0.1;
// Heading drift to expect a metre of path, and at most.
constexpr double kTurnPerMetre_rad = 0.002, kMostHalfAngle_rad = 0.3;
constexpr std::size_t kMinOldPoints = 1000;

IcpOptions refinement(IcpOptions icp)
{
    icp.max_pair_distance_m = std::max(icp.max_pair_distance_m, 1.0);
    icp.final_pair_distance_m = std::max(icp.final_pair_distance_m, 0.2);
    icp.kernel_scale_m = icp.final_pair_distance_m;
    return icp;
}

DensityOptions near(double vicinity_m)
{
    DensityOptions density;
    density.vicinity_m = vicinity_m;
    return density;
}

DrawOptions draws(int points)
{
    DrawOptions draw;
    draw.points = points;
    return draw;
}

/// The correction without its part along a direction that the old scans do not hold.
Pose2 along_held_directions(const IcpResult& fit, const Drift& drift)
{
    const auto held = drift.onlyHeldDirection(fit);
    if (!held) return fit.correction;
    const double along = held->x() * fit.correction.x + held->y() * fit.correction.y;
    return {held->x() * along, held->y() * along, fit.correction.yaw};
}
}  // namespace

void LoopSearchOptions::validate() const
{
    require(max_half_width_m > 0, "max_half_width_m", max_half_width_m, "> 0");
    require(min_path_m > 0, "min_path_m", min_path_m, "> 0");
    require(step_m > 0, "step_m", step_m, "> 0");
    require(local_path_m > 0, "local_path_m", local_path_m, "> 0");
    require(vicinity_m > 0, "vicinity_m", vicinity_m, "> 0");
    require(local_points >= 100, "local_points", local_points, ">= 100");
    require(min_score > 0 && min_score <= 1, "min_score", min_score, "in (0, 1]");
    require(
        min_paired_share > 0 && min_paired_share <= 1, "min_paired_share", min_paired_share,
        "in (0, 1]");
}

LoopSearch::LoopSearch(const LoopSearchOptions& options, const IcpOptions& icp, std::uint64_t seed)
    : options_(options),
      icp_(refinement(icp)),
      density_(near(options.vicinity_m)),
      old_draw_(draws(3600)),
      local_draw_(draws(options.local_points)),
      random_(seed)
{
    options_.validate();
}

std::optional<LoopFound> LoopSearch::search(
    const MapView& map, const TravelLog& travel, const Drift& drift, double time_s,
    const Pose2& pose_map_vehicle, std::size_t old_end)
{
    const double path_m = drift.path_m(travel);
    if (!options_.enabled || path_m < options_.min_path_m ||
        travel.path() - searched_path_m_ < options_.step_m)
        return std::nullopt;
    searched_path_m_ = travel.path();

    Moment moment{time_s, pose_map_vehicle.x, pose_map_vehicle.y, 0, old_end};
    old_draw_.draw(map, density_, moment, std::nullopt, random_, old_);
    if (old_.indices.size() < kMinOldPoints) return std::nullopt;
    moment.scans_begin = travel.scansBefore(options_.local_path_m);
    moment.scans_end = map.scans.size();
    local_draw_.draw(map, density_, moment, std::nullopt, random_, local_);

    auto fit = find(path_m, drift.expected_m(travel));
    if (!fit)
    {
        last_correction_.reset();
        return std::nullopt;
    }
    fit->correction = along_held_directions(*fit, drift);
    const bool confirmed = agrees(fit->correction);
    last_correction_ = fit->correction;
    if (!confirmed) return std::nullopt;
    last_correction_.reset();
    turn_points({0, 0, fit->correction.yaw}, local_.points.view(), local_turned_);
    return LoopFound{
        *fit, support_.newest(
                  map.scans, old_, local_turned_.view(), local_.origin_x + fit->correction.x,
                  local_.origin_y + fit->correction.y)};
}

/// Searches the window for the local points among the old ones, and refines what it found.
std::optional<IcpResult> LoopSearch::find(double path_m, double drift_m)
{
    const SearchWindow window{
        std::min(options_.max_half_width_m, kLeastHalfWidth_m + drift_m),
        std::min(kMostHalfAngle_rad, kLeastHalfAngle_rad + kTurnPerMetre_rad * path_m),
        options_.min_score};
    const SearchResult found = search_.search(local_.points.view(), old_.points.view(), window);
    if (found.score < options_.min_score) return std::nullopt;

    // ICP starts from what was found: the local points turned, the old ones shifted back.
    turn_points({0, 0, found.correction.yaw}, local_.points.view(), local_turned_);
    old_shifted_.clear();
    for (std::size_t i = 0; i < old_.points.size(); ++i)
        old_shifted_.add(
            old_.points.x[i] - static_cast<float>(found.correction.x),
            old_.points.y[i] - static_cast<float>(found.correction.y));
    IcpResult fit = icp_.align(local_turned_.view(), old_shifted_.view());
    if (fit.paired_share < options_.min_paired_share) return std::nullopt;
    fit.correction = apply_correction(found.correction, fit.correction);
    return fit;
}

bool LoopSearch::agrees(const Pose2& correction) const
{
    return last_correction_ &&
           std::hypot(correction.x - last_correction_->x, correction.y - last_correction_->y) <
               kAgree_m &&
           std::abs(wrap_angle(correction.yaw - last_correction_->yaw)) < kAgree_rad;
}
}  // namespace rtob

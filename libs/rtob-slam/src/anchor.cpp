// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/slam/anchor.h>
#include <rtob/slam/turned_points.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
void AnchorOptions::validate() const
{
    require(min_path_m > 0, "min_path_m", min_path_m, "> 0");
    require(max_pair_distance_m > 0, "max_pair_distance_m", max_pair_distance_m, "> 0");
    require(
        min_paired_share > 0 && min_paired_share <= 1, "min_paired_share", min_paired_share,
        "in (0, 1]");
    require(error_slack_m2 >= 0, "error_slack_m2", error_slack_m2, ">= 0");
    require(min_points >= 10, "min_points", min_points, ">= 10");
}

namespace
{
IcpOptions with_pair_distance(IcpOptions options, double max_pair_distance_m)
{
    options.max_pair_distance_m = std::max(max_pair_distance_m, options.final_pair_distance_m);
    return options;
}
}  // namespace

Anchor::Anchor(
    const AnchorOptions& options, const IcpOptions& icp, const DensityOptions& density,
    const DrawOptions& draw, std::uint64_t seed)
    : options_(options),
      icp_(with_pair_distance(icp, options.max_pair_distance_m)),
      density_(density),
      draw_(draw),
      random_(seed)
{
    options_.validate();
}

void Anchor::inserted(const Pose2& pose_map_vehicle)
{
    const float step_m =
        path_m_.empty()
            ? 0.0f
            : static_cast<float>(
                  std::hypot(pose_map_vehicle.x - last_pose_.x, pose_map_vehicle.y - last_pose_.y));
    path_m_.push_back(path_m_.empty() ? 0.0f : path_m_.back() + step_m);
    last_pose_ = pose_map_vehicle;
    while (old_end_ < path_m_.size() &&
           path_m_[old_end_] < path_m_.back() - static_cast<float>(options_.min_path_m))
        ++old_end_;
}

std::optional<IcpResult> Anchor::align(
    const MapView& map, double time_s, const Pose2& pose_map_vehicle, const IcpResult& fit,
    const Points& points_vehicle)
{
    if (!options_.enabled || old_end_ == 0) return std::nullopt;
    const Box gate = turn_points(pose_map_vehicle, points_vehicle.view(), points_turned_)
                         .grown(options_.max_pair_distance_m);
    draw_.draw(
        map, density_, {time_s, pose_map_vehicle.x, pose_map_vehicle.y, old_end_}, gate, random_,
        reference_);
    if (reference_.indices.size() < static_cast<std::size_t>(options_.min_points))
        return std::nullopt;
    IcpResult old_fit = icp_.align(points_turned_.view(), reference_.points.view());
    const bool explains =
        old_fit.paired_share >= options_.min_paired_share &&
        old_fit.mean_squared_error <= fit.mean_squared_error + options_.error_slack_m2;
    return explains ? std::optional(old_fit) : std::nullopt;
}
}  // namespace rtob

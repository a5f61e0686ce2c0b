// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/slam/local_reference.h>

#include <cmath>

namespace rtob
{
void ReferenceOptions::validate() const
{
    require(reuse_m >= 0, "reuse_m", reuse_m, ">= 0");
    require(reuse_s >= 0, "reuse_s", reuse_s, ">= 0");
    require(less_share >= 0 && less_share <= 1, "less_share", less_share, "in [0, 1]");
}

LocalReference::LocalReference(const ReferenceOptions& options) : options_(options)
{
    options_.validate();
}

bool LocalReference::serves(double time_s, const Pose2& pose_map_init, const Box& needed_map) const
{
    return drawn_at_ && options_.reuse_m > 0 && time_s - drawn_s_ <= options_.reuse_s &&
           std::hypot(pose_map_init.x - drawn_at_->x, pose_map_init.y - drawn_at_->y) <=
               options_.reuse_m &&
           covered_map_.contains(needed_map);
}

IcpResult LocalReference::align(
    Icp& icp, const PointsView& points_turned, const Pose2& pose_map_init, IcpReach reach)
{
    const IcpResult fit = icp.align(
        points_turned, prepared_,
        {pose_map_init.x - sample_.origin_x, pose_map_init.y - sample_.origin_y}, {}, reach);
    if (!first_share_) first_share_ = fit.paired_share;
    return fit;
}

bool LocalReference::isWorse(const IcpResult& fit) const
{
    return first_share_ && fit.paired_share < *first_share_ - options_.less_share;
}
}  // namespace rtob

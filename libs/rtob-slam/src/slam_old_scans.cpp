// SPDX-License-Identifier: BSD-3-Clause
// What scans from before a loop say of a match, and the way of a loop that is closed.
#include "step_timer.h"

#include <rtob/slam/bent_way.h>
#include <rtob/slam/slam.h>

#include <algorithm>

namespace rtob
{
/// Beyond the paper: in places seen before, the old scans decide.
void Slam::anchor(Match& match)
{
    const StepTimer timer(report_.times.anchor_s);
    const auto old_fit = anchor_.align(
        map_.view(), travel_, drift_, report_.map_time_s, match.pose_map_vehicle, match.fit,
        matched_vehicle_);
    if (!old_fit) return;
    report_.anchored = true;
    match.pose_map_vehicle = apply_correction(match.pose_map_vehicle, old_fit->correction);
    match.fit = *old_fit;
    match.covariance_old = old_fit->covariance;
    drift_.held(travel_, *old_fit);
}

/// Beyond the paper: after a long loop, the place is looked for.
void Slam::closeLoop(Match& match)
{
    const StepTimer timer(report_.times.search_s);
    const auto found = loop_search_.search(
        map_.view(), travel_, drift_, report_.map_time_s, match.pose_map_vehicle,
        travel_.scansBefore(options_.anchor.min_path_m));
    if (!found) return;
    report_.closed_loop = true;
    const Pose2 end = match.pose_map_vehicle;
    match.pose_map_vehicle = apply_correction(end, found->fit.correction);
    match.covariance_old = found->fit.covariance;
    if (options_.loop_search.bend_way) bendWay(found->old_scan + 1, end, match.pose_map_vehicle);
    drift_.held(travel_, found->fit);
}

/// The scans of the loop that has been closed take their shares of its error. Of the way only what
/// came after old scans last held the pose may have gone astray.
void Slam::bendWay(std::size_t after_old, const Pose2& end, const Pose2& end_now)
{
    const std::size_t first = std::max(after_old, travel_.scansBefore(drift_.path_m(travel_)));
    if (first >= map_.scans().size()) return;
    bend_way(map_.scans(), travel_, first, end, end_now, bent_way_);
    map_.moveScans(first, bent_way_);
    travel_.moved(bent_way_.back());
    local_.drop();
    local_before_.drop();
    anchor_.forgetMap();
    relocaliser_.forgetMap();
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
// Maps that stay and that stay small, and the way back into them for a vehicle that is lost.
#include "step_timer.h"

#include <rtob/slam/slam.h>

#include <algorithm>

namespace rtob
{
namespace
{
// After a scan that did not follow the last one, the next must do so by more than usual.
constexpr double kMoreAgreement = 0.1;
}  // namespace

void Slam::continueIn(const RtobMap& map, const std::optional<Pose2>& pose_map_vehicle)
{
    map_ = map;
    map_.setOptions(map_options(options_));
    insertion_.clear();
    travel_ = TravelLog();
    for (std::size_t scan = 0; scan < map_.scans().size(); ++scan)
        travel_.inserted(map_.scans().pose(scan));
    thinner_.makeRoom(map_, travel_);
    scans_of_map_ = map_.scans().size();
    drift_ = Drift(options_.drift);
    drift_.heldNow(travel_);  // the pose is given, or will be found, in this map
    tracking_ = TrackingStateMachine(options_.tracking);
    if (!map_.scans().empty()) tracking_.start();
    relocaliser_.forgetMap();
    if (!map_.scans().empty() && !pose_map_vehicle) tracking_.lose();
    report_ = ScanReport();
    report_.state = tracking_.state();
    reset(pose_map_vehicle.value_or(Pose2{}));
}

void Slam::reset(const Pose2& pose_map_vehicle)
{
    prealignment_.reset(pose_map_vehicle);
    motion_.reset(pose_map_vehicle);
    belief_.begin();
    matched_at_ = pose_map_vehicle;
    local_.drop();
    continuity_.clear();
    relocaliser_.restart();
    report_.pose_map_vehicle = pose_map_vehicle;
}

void Slam::thinMap()
{
    const std::vector<char>& keep = thinner_.choose(map_.scans());
    map_.keepOnly(keep);
    travel_.keepOnly(keep);
    local_.drop();
}

/// Whether the scan, although it may fit the map, does not follow the last one: the vehicle may
/// have been carried into a place like its own.
bool Slam::isTorn(const Match& match, const std::string& laser)
{
    const double usual = options_.tracking.min_agreement;
    if (usual == 0 || !is_match(match.verdict)) return false;
    const bool is_doubted = tracking_.state() == TrackingState::Degraded;
    const double least = std::min(1.0, usual + (is_doubted ? kMoreAgreement : 0.0));
    const StepTimer timer(report_.times.align_s);
    return continuity_.agreement(laser, match.pose_map_vehicle, points_vehicle_) < least;
}

/// A scan of a vehicle that is lost: a step of the search through the whole map.
const ScanReport& Slam::recover(const Pose2& pose_map_init, const std::string& laser)
{
    report_.searched = true;
    std::optional<PlaceEvidence> found;
    {
        const StepTimer timer(report_.times.search_s);
        std::optional<Pose2> pose_prev_now;
        if (hasOdometry() || motion_.decides())
            pose_prev_now = between(prealignment_.last(), pose_map_init);
        found = relocaliser_.take(map_.view(), points_vehicle_, pose_prev_now);
    }
    if (!found)
    {
        tracking_.lose(relocaliser_.hasCandidates());
        report({pose_map_init, {}, FitVerdict::Weak}, tracking_.state());
        return report_;
    }
    reset(found->pose_map_vehicle);
    drift_.heldNow(travel_);
    tracking_.start();
    report({found->pose_map_vehicle, found->fit, FitVerdict::Good, true}, tracking_.state());
    continuity_.tracked(laser, found->pose_map_vehicle, points_vehicle_);
    return report_;
}
}  // namespace rtob

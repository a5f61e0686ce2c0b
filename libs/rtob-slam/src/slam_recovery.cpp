// SPDX-License-Identifier: BSD-3-Clause
// Maps that stay and that stay small, and the way back into them for a vehicle that is lost.
#include "step_timer.h"

#include <rtob/slam/slam.h>

#include <cmath>

namespace rtob
{
namespace
{
// A vehicle that is carried away seldom fits nearer than this to where it was expected. Less would
// see more of them, but without odometry nobody knows when a turn begins, and wheels slip: with
// 0.08 m and 0.08 rad runs of Intel without odometry and of Killian went astray.
constexpr double kJump_m = 0.3, kJump_rad = 0.3;
// By this share of the way from the last scan a drive may be expected wrongly.
constexpr double kJumpShare = 0.5;
// Nor does it find that much of what it sees in the map where it is not.
constexpr double kSureShare = 0.93;

/// @param last where the vehicle was, @param expected where it should be, @param found where it
/// fits
bool is_jump(const Pose2& last, const Pose2& expected, const Pose2& found)
{
    const Pose2 way = between(last, expected), error = between(expected, found);
    return std::hypot(error.x, error.y) > kJump_m + kJumpShare * std::hypot(way.x, way.y) ||
           std::abs(error.yaw) > kJump_rad + kJumpShare * std::abs(way.yaw);
}
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
    doubted_scans_ = 0;
    report_.pose_map_vehicle = pose_map_vehicle;
}

void Slam::thinMap()
{
    const std::vector<char>& keep = thinner_.choose(map_.scans());
    map_.keepOnly(keep);
    travel_.keepOnly(keep);
    local_.drop();
}

/// A scan may fit the map and yet not follow the last one: the vehicle may have been carried into a
/// place like its own. Then nothing is written until the place has stood against all others.
void Slam::doubt(const Pose2& pose_map_init, const std::string& laser, Match& match)
{
    const double least = options_.tracking.min_agreement;
    if (least == 0 || !relocaliser_.enabled()) return;
    if (!Relocaliser::tellsPlaces(points_vehicle_)) match.verdict = FitVerdict::Weak;
    if (doubted_scans_ == 0)
    {
        const StepTimer timer(report_.times.align_s);
        if (!is_match(match.verdict) ||
            !is_jump(prealignment_.last(), pose_map_init, match.pose_map_vehicle) ||
            continuity_.agreement(laser, match.pose_map_vehicle, points_vehicle_) >= least)
            return;
        relocaliser_.restart();
    }
    ++doubted_scans_;
    match.is_doubted = true;
    if (!is_match(match.verdict))
    {
        (void)lookEverywhere(pose_map_init, std::nullopt);
        return;
    }
    const Pose2& tracked = match.pose_map_vehicle;
    const auto found = lookEverywhere(pose_map_init, tracked);
    match.is_elsewhere = match.fit.known_share < kSureShare && relocaliser_.isElsewhere(tracked);
    // Where nothing decides, the vehicle has more likely driven than been carried.
    const bool is_alone =
        doubted_scans_ >= options_.relocalise.max_scans / 2 && !relocaliser_.hasRival(tracked);
    const bool has_stood = found || is_alone || doubted_scans_ >= options_.relocalise.max_scans;
    if (match.is_elsewhere || !has_stood) return;
    relocaliser_.restart();
    match.is_doubted = false;
    doubted_scans_ = 0;
}

/// A step of the search through the whole map.
/// @param pose_map_tracked a place that is looked at, too.
std::optional<PlaceEvidence> Slam::lookEverywhere(
    const Pose2& pose_map_init, const std::optional<Pose2>& pose_map_tracked)
{
    report_.searched = true;
    const StepTimer timer(report_.times.search_s);
    std::optional<Pose2> pose_prev_now;
    if (hasOdometry() || motion_.decides())
        pose_prev_now = between(prealignment_.last(), pose_map_init);
    return relocaliser_.take(map_.view(), points_vehicle_, pose_prev_now, pose_map_tracked);
}

/// A scan of a vehicle that is lost.
const ScanReport& Slam::recover(const Pose2& pose_map_init, const std::string& laser)
{
    const auto found = lookEverywhere(pose_map_init, std::nullopt);
    if (!found)
    {
        tracking_.lose(relocaliser_.hasCandidates());
        report({pose_map_init, {}, FitVerdict::Weak}, tracking_.state());
        return report_;
    }
    reset(found->pose_map_vehicle);
    drift_.heldNow(travel_);
    tracking_.start();
    belief_.forget();
    const Pose2& pose = found->pose_map_vehicle;
    report({pose, found->fit, FitVerdict::Good, pose, found->fit}, tracking_.state());
    continuity_.tracked(laser, found->pose_map_vehicle, points_vehicle_);
    return report_;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
// Maps that stay and that stay small, and the way back into them for a vehicle that is lost.
#include "step_timer.h"

#include <rtob/slam/slam.h>
#include <rtob/slam/turned_points.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rtob
{
namespace
{
// A vehicle that was carried away seldom fits nearer than this to where it was expected.
constexpr double kJump_m = 0.05, kJump_rad = 0.05;
// By this share of the way from the last scan a drive may be expected wrongly.
constexpr double kJumpShare = 0.5;
// It was, where another place explains the scans so much better than the tracked one and any third,
// in logarithms of the misfit, summed over the scans. A lead of 4 once took slambot's vehicle 5 m
// off, which had not been carried away.
constexpr double kLeadOverTracked = 5, kLeadOverOthers = 1;
// Where the first scan agreed more than this with the one before, as the fragment of one does, more
// is asked, by so much for each share of the points.
constexpr double kClearBreak = 0.7, kLeadForAgreement = 30;
// A vehicle that has moved less since the doubt began sees what it has written itself.
constexpr double kStood_m = 0.1, kStood_rad = 0.1;
// A place that explains so much of a scan has no rival that could lead by enough.
constexpr double kWellExplained = 0.9;
// A place that has stood for so many scans stands.
constexpr int kStands_scans = 6;

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
    map_belief_.clear();
    for (std::size_t scan = 0; scan < map_.scans().size(); ++scan)
    {
        travel_.inserted(map_.scans().pose(scan));
        map_belief_.inserted(Eigen::Matrix3d::Zero());  // the map is taken as it is
    }
    thinner_.makeRoom(map_, travel_, map_belief_);
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
    doubt_ = {};
    report_.pose_map_vehicle = pose_map_vehicle;
}

/// @param keep one entry a scan: 0 to forget it
void Slam::keepOnly(const std::vector<char>& keep)
{
    map_.keepOnly(keep);
    travel_.keepOnly(keep);
    map_belief_.keepOnly(keep);
    local_.drop();
}

/// A scan may fit the map and yet not follow the last one: the vehicle may have been carried into a
/// place like its own. Then the place has to stand against all others. Until it has, tracking goes
/// on as ever, and should it turn out to be elsewhere, what was written meanwhile is taken back.
void Slam::doubt(const Pose2& pose_map_init, const std::string& laser, Match& match)
{
    if (options_.tracking.min_agreement == 0 || !relocaliser_.enabled()) return;
    if (!Relocaliser::tellsPlaces(points_vehicle_)) match.verdict = FitVerdict::Weak;
    if (doubt_.scans == 0 && !beginsDoubt(pose_map_init, laser, match)) return;
    ++doubt_.scans;
    const Pose2& tracked = match.pose_map_vehicle;
    const bool is_tracked = is_match(match.verdict);
    (void)lookEverywhere(pose_map_init, is_tracked ? std::optional(tracked) : std::nullopt);
    const double log_misfit = PlaceEvidence::logMisfit(explainedShare(match));
    const int followed = relocaliser_.scansFollowed();
    doubt_.log_misfit = followed > 1 ? doubt_.log_misfit + log_misfit : log_misfit;
    if (!is_tracked) return;  // LOST, if it goes on
    match.is_elsewhere = isElsewhere(tracked);
    const bool has_stood =
        followed >= kStands_scans || doubt_.scans >= options_.relocalise.max_scans ||
        (followed >= options_.relocalise.confirm_scans && !relocaliser_.hasRival(tracked));
    if (match.is_elsewhere || !has_stood) return;
    doubt_ = {};
    relocaliser_.restart();
    relocaliser_.forgetMap();  // which has grown since
}

bool Slam::beginsDoubt(const Pose2& pose_map_init, const std::string& laser, const Match& match)
{
    const StepTimer timer(report_.times.align_s);
    if (!is_match(match.verdict) ||
        !is_jump(prealignment_.last(), pose_map_init, match.pose_map_vehicle))
        return false;
    const double agreement = continuity_.agreement(laser, match.pose_map_vehicle, points_vehicle_);
    if (agreement >= options_.tracking.min_agreement || match.fit.known_share >= kWellExplained)
        return false;
    doubt_ = {0, agreement, 0, map_.scans().size(), match.pose_map_vehicle};
    local_before_ = local_;
    relocaliser_.restart();
    return true;
}

/// [0, 1] of the scan, at the tracked place. Of a vehicle that stands, by what was drawn before the
/// doubt: what was written since explains itself. What was drawn before soon falls behind one that
/// moves on into new ground.
double Slam::explainedShare(const Match& match)
{
    const Pose2& tracked = match.pose_map_vehicle;
    if (!is_match(match.verdict) || !is_near(doubt_.pose_map_first, tracked, kStood_m, kStood_rad))
        return match.fit.known_share;
    const StepTimer timer(report_.times.align_s);
    turn_points(tracked, matched_vehicle_.view(), points_turned_);
    return local_before_.align(icp_, points_turned_.view(), tracked).known_share;
}

bool Slam::isElsewhere(const Pose2& pose_map_tracked) const
{
    const PlaceLead lead = relocaliser_.leadOver(pose_map_tracked, doubt_.log_misfit);
    const double enough =
        kLeadOverTracked + kLeadForAgreement * std::max(0.0, doubt_.agreement - kClearBreak);
    return lead.over_tracked >= enough && lead.over_others >= kLeadOverOthers;
}

/// The vehicle was not where the scans of the doubt were written.
void Slam::takeBackDoubted()
{
    const bool has_written = doubt_.scans > 0 && map_.scans().size() > doubt_.scans_before;
    if (has_written)
    {
        std::vector<char> keep(map_.scans().size(), 0);
        std::fill_n(keep.begin(), doubt_.scans_before, 1);
        keepOnly(keep);
        insertion_.clear();
    }
    doubt_ = {};
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
    const Pose2& pose = found->pose_map_vehicle;
    belief_.forget(map_belief_.near(map_.view(), pose, map_.scans().size()));
    report({pose, found->fit, FitVerdict::Good, pose, found->fit}, tracking_.state());
    continuity_.tracked(laser, found->pose_map_vehicle, points_vehicle_);
    return report_;
}
}  // namespace rtob

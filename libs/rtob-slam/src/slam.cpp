// SPDX-License-Identifier: BSD-3-Clause
#include "step_timer.h"

#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/map/conversions.h>
#include <rtob/slam/slam.h>
#include <rtob/slam/spread_points.h>

#include <algorithm>

namespace rtob
{
namespace
{
// A map that fewer scans have met may start anew with a richer scan that does not fit it.
constexpr std::size_t kYoungMap_scans = 3;

/// No match of so few points can pass the gate; as the first scan they would be a map that nothing
/// fits.
bool is_too_small(const Points& points_vehicle, const FitGateOptions& gate)
{
    return points_vehicle.size() < static_cast<std::size_t>(gate.min_pairs);
}

SlamOptions validated(const SlamOptions& options)
{
    options.validate();
    return options;
}
}  // namespace

RtobMapOptions map_options(const SlamOptions& options)
{
    RtobMapOptions map;
    map.density = options.density;
    map.draw = options.draw;
    map.seed = options.seed;
    return map;
}

Slam::Slam(const SlamOptions& options)
    : options_(validated(options)),
      map_(map_options(options)),
      sensor_(options.sensor),
      filter_(options.scan_filter),
      motion_(options.prealign.source, options.fusion, options.scan),
      prealignment_(options.prealign),
      belief_(options.fusion),
      icp_(options.icp),
      tracking_(options.tracking),
      insertion_(options.insertion),
      drift_(options.drift),
      anchor_(
          options.anchor, options.icp, options.density, options.draw, options.reference,
          options.seed),
      loop_search_(options.loop_search, options.icp, options.seed),
      search_(options.search),
      continuity_(options.icp),
      relocaliser_(options.relocalise, options.icp),
      thinner_(options.map.max_points),
      local_(options.reference),
      local_before_(options.reference)
{
    matched_vehicle_.reserve(static_cast<std::size_t>(
        std::min(options.scan_filter.max_matched, options.scan_filter.max_beams)));
}

const ScanReport* Slam::observe(const mrpt::obs::CObservation& observation)
{
    if (const auto* odometry = dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation))
        prealignment_.addOdometry(to_pose2(odometry->odometry));
    motion_.observe(observation);
    const auto* scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&observation);
    return scan != nullptr && sensor_.uses(*scan) ? &process(*scan) : nullptr;
}

void Slam::observe(const mrpt::obs::CActionRobotMovement2D& motion)
{
    const Pose2 pose_prev_now = to_pose2(motion.poseChange->getMeanVal());
    prealignment_.addMotion(pose_prev_now);
    motion_.addMotion(pose_prev_now);
}

const ScanReport& Slam::process(const mrpt::obs::CObservation2DRangeScan& scan)
{
    begin(scan);
    filter(scan);                            // 1. eq. 1
    const Pose2 pose_map_init = prealign();  // 2. eq. 2 and 3
    if (is_too_small(points_vehicle_, options_.fit_gate))
        return settle({pose_map_init, {}, FitVerdict::None});
    if (map_.scans().empty()) return startMap(pose_map_init, scan.sensorLabel);
    if (tracking_.isLost() && relocaliser_.enabled())
        return recover(pose_map_init, scan.sensorLabel);

    Match match = matchGuess(pose_map_init);  // 3. to 6.: eq. 5, ICP, eq. 4, gate
    if (isDoubtful(match)) searchAround(pose_map_init, match);
    holdToOdometry(pose_map_init, match);
    if (isFalseStart(match)) return startMap(pose_map_init, scan.sensorLabel);
    doubt(pose_map_init, scan.sensorLabel, match);
    if (match.verdict == FitVerdict::Good && options_.remembers() &&
        wantsToWrite(match, scan.sensorLabel))
    {
        anchor(match);
        closeLoop(match);
    }
    settle(match);
    if (is_match(match.verdict))
        continuity_.tracked(scan.sensorLabel, report_.pose_map_vehicle, points_vehicle_);
    insert(match, scan.sensorLabel);  // 7.
    return report_;                   // 8.
}

void Slam::begin(const mrpt::obs::CObservation2DRangeScan& scan)
{
    const double stamp_s = stamp_of(scan);
    const TrackingState state = report_.state;
    report_ = ScanReport();
    report_.stamp_s = stamp_s;
    ++scans_of_map_;
    report_.map_time_s = map_.tick(stamp_s);
    report_.state = state;
    const StepTimer timer(report_.times.prealign_s);
    motion_.beginScan(stamp_s, scan);
}

void Slam::filter(const mrpt::obs::CObservation2DRangeScan& scan)
{
    const StepTimer timer(report_.times.filter_s);
    const ScanGeometry geometry =
        motion_.geometry(sensor_.mountOf(scan), prealignment_.twist(report_.stamp_s));
    report_.beams = filter_.filter(scan, geometry, points_vehicle_);
    spread_points(
        points_vehicle_.view(), static_cast<std::size_t>(options_.scan_filter.max_matched),
        matched_vehicle_);
}

Pose2 Slam::prealign()
{
    const StepTimer timer(report_.times.prealign_s);
    const Pose2 pose_map_init = predicted();
    const Pose2& last = prealignment_.last();
    belief_.advance(
        prealignment_.stepTo(report_.stamp_s), {pose_map_init.x - last.x, pose_map_init.y - last.y},
        prealignment_.goesByOdometry());
    return pose_map_init;
}

Pose2 Slam::predicted() const
{
    return motion_.decides() ? motion_.predicted().pose() : prealignment_.predict(report_.stamp_s);
}

/// Whether the scan is to join the map, if nothing speaks against it.
bool Slam::wantsToWrite(const Match& match, const std::string& laser) const
{
    return !options_.map.localize &&
           insertion_.wants(laser, report_.map_time_s, match.pose_map_vehicle);
}

/// Whether the map began with a poor scan, as lasers give while they spin up.
bool Slam::isFalseStart(const Match& match) const
{
    return !is_match(match.verdict) && scans_of_map_ < kYoungMap_scans && !options_.map.localize &&
           points_vehicle_.size() > map_.size();
}

const ScanReport& Slam::startMap(const Pose2& pose_map_init, const std::string& laser)
{
    map_.clear();
    local_.drop();
    scans_of_map_ = 1;
    doubt_ = {};
    insertion_.clear();
    travel_ = TravelLog();
    map_belief_.clear();
    thinner_.makeRoom(map_, travel_, map_belief_);
    drift_ = Drift(options_.drift);
    report_.searched = false;  // nothing of what was found is used
    report_.map_time_s = map_.tick(report_.stamp_s);
    tracking_.start();
    report({pose_map_init, {}, FitVerdict::Good, pose_map_init}, tracking_.state());
    belief_.begin();  // the map's frame is the first pose, by definition
    report_.covariance = report_.covariance_in_map = belief_.inMap();
    continuity_.tracked(laser, report_.pose_map_vehicle, points_vehicle_);
    insert(Match{pose_map_init, {}, FitVerdict::Good}, laser);
    return report_;
}

const ScanReport& Slam::settle(const Match& match)
{
    if (match.is_elsewhere)
        tracking_.lose(true);
    else if (tracking_.state() != TrackingState::Init)
        tracking_.next(match.verdict);
    if (tracking_.isLost()) takeBackDoubted();
    report(match, tracking_.state());
    return report_;
}

void Slam::report(const Match& match, TrackingState state)
{
    const bool matched = is_match(match.verdict) &&
                         (state == TrackingState::Tracking || state == TrackingState::Relocalising);
    report_.state = state;
    report_.doubted = doubt_.scans > 0;
    report_.verdict = match.verdict;
    report_.pose_map_vehicle = matched ? match.pose_map_vehicle : predicted();
    Eigen::Matrix3d believed = Eigen::Matrix3d::Identity();
    if (matched)
    {
        matched_at_ = match.pose_map_vehicle;
        believed = velocity_shown(match.fit_local);
        believe(match);
    }
    report_.covariance = belief_.inLocalMap();
    report_.covariance_in_map = belief_.inMap();
    report_.weak = weak_direction(match.fit_local.information);
    report_.held_by_guess = matched && options_.icp.metric == IcpMetric::PointToLine &&
                            report_.weak.share < options_.icp.weak_share;
    report_.mean_squared_error_m2 = match.fit.mean_squared_error;
    report_.paired_share = match.fit.paired_share;
    report_.pairs = match.fit.pairs;
    prealignment_.settle(
        report_.stamp_s, matched ? match.pose_map_local : report_.pose_map_vehicle, matched,
        believed);
    prealignment_.correct(report_.pose_map_vehicle);
    motion_.settle(report_.pose_map_vehicle, match.fit_local.covariance, matched);
}

/// What the match tells of how far off the pose may be.
void Slam::believe(const Match& match)
{
    belief_.matched(match.fit_local.covariance);
    if (!match.covariance_old) return;
    const std::size_t old_end = travel_.scansBefore(options_.anchor.min_path_m);
    belief_.held(
        *match.covariance_old, map_belief_.near(map_.view(), match.pose_map_vehicle, old_end));
}

/// Only what was matched while TRACKING enters the map. What a search found must first be confirmed
/// by a scan that needs no search.
void Slam::insert(const Match& match, const std::string& laser)
{
    const StepTimer timer(report_.times.insert_s);
    const bool may_write =
        report_.state == TrackingState::Tracking && is_match(match.verdict) && !match.is_found;
    if (!may_write || !wantsToWrite(match, laser)) return;
    const bool is_doubted = doubt_.scans > 0;
    if (thinner_.isDue(map_, points_vehicle_.size()))
    {
        if (is_doubted) return;  // a thinned map could not be taken back
        keepOnly(thinner_.choose(map_.scans()));
    }
    map_.insertScan(report_.map_time_s, report_.pose_map_vehicle, points_vehicle_.view());
    insertion_.inserted(laser, report_.map_time_s, report_.pose_map_vehicle);
    travel_.inserted(report_.pose_map_vehicle);
    map_belief_.inserted(belief_.inMap());
    belief_.inserted();
    if (!is_doubted) relocaliser_.forgetMap();
    report_.inserted = true;
}
}  // namespace rtob

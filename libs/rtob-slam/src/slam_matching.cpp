// SPDX-License-Identifier: BSD-3-Clause
// Where a scan belongs in the map: steps 3 to 6 of process(), and what goes beyond the paper.
#include "step_timer.h"

#include <rtob/slam/slam.h>
#include <rtob/slam/turned_points.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtob
{
namespace
{
// Of what a match leaves unexplained, a search may leave this share to take its place.
constexpr double kUnexplainedLeftWithOdometry = 1.0 / 3;

// Another match within this of one from odometry takes its place where it leaves this share of what
// that leaves unexplained.
constexpr double kBeside_m = 0.2, kBeside_rad = 0.2, kBetterBeside = 0.95;

// Without odometry: guesses that differ by less than this lead to the same match.
constexpr double kSameTurn_rad = 0.03;
// The second guess has to leave this share of what the first one leaves unexplained.
constexpr double kBetterShare = 0.8;

// Slower from scan to scan, a vehicle shows nothing of its odometry.
constexpr double kStands_m = 0.02, kStands_rad = 0.02;

// What contradicts odometry has to leave so much less unexplained than what agrees with it.
constexpr double kAboutAsWell = 1.5;

// How far odometry may mislead from one match to the next: by slip, and by a share of the way.
constexpr double kSlip_m = 0.3, kSlipShare = 1.0;
}  // namespace

/// Without odometry and gyro nobody says when a turn ends, and between two scans it may: so both is
/// tried.
Slam::Match Slam::matchGuess(const Pose2& pose_map_init)
{
    const Match going_on = matchAround(pose_map_init);
    const Pose2& at_rest = prealignment_.last();
    if (hasOdometry() || motion_.decides() ||
        std::abs(wrap_angle(pose_map_init.yaw - at_rest.yaw)) < kSameTurn_rad)
        return going_on;
    const Match ended = matchAround(at_rest);
    const double distance_m = options_.icp.final_pair_distance_m;
    const bool has_ended =
        misfit_m2(ended.fit, distance_m) < kBetterShare * misfit_m2(going_on.fit, distance_m);
    return has_ended ? ended : going_on;
}

Slam::Match Slam::matchAround(const Pose2& pose_map_init, IcpReach reach)
{
    const Box needed_map = turn_points(pose_map_init, matched_vehicle_.view(), points_turned_)
                               .grown(options_.icp.max_pair_distance_m);
    const bool is_reused = local_.serves(report_.map_time_s, pose_map_init, needed_map);
    if (!is_reused) drawAround(pose_map_init, needed_map);
    Match match = alignAround(pose_map_init, reach);
    if (!is_reused || !local_.isWorse(match.fit)) return match;
    drawAround(pose_map_init, needed_map);
    return alignAround(pose_map_init, reach);
}

void Slam::drawAround(const Pose2& pose_map_init, const Box& needed_map)
{
    const StepTimer timer(report_.times.draw_s);
    local_.renew(
        icp_, report_.map_time_s, pose_map_init, needed_map,
        [&](const Box& box_map, Reference& reference)
        { map_.draw(pose_map_init, box_map, trustedBegin(), reference); });
}

Slam::Match Slam::alignAround(const Pose2& pose_map_init, IcpReach reach)
{
    const StepTimer timer(report_.times.align_s);
    Match match;
    match.fit = local_.align(icp_, points_turned_.view(), pose_map_init, reach);
    match.pose_map_vehicle = apply_correction(pose_map_init, match.fit.correction);
    match.verdict = judge_fit(match.fit, options_.fit_gate);
    match.pose_map_local = match.pose_map_vehicle;
    match.fit_local = match.fit;
    return match;
}

/// Old scans from which the newest may have drifted apart would mislead.
std::size_t Slam::trustedBegin() const
{
    return options_.remembers() && !tracking_.isLost() ? drift_.trustedBegin(travel_) : 0;
}

/// Whether ICP from the guess alone is to be trusted.
bool Slam::isDoubtful(const Match& match) const
{
    // Where the map knows the place, most of a scan finds a neighbour, or the guess was bad.
    const bool explains_little = match.fit.known_share < options_.search.min_paired_share;
    return search_.enabled() && (match.verdict == FitVerdict::Weak || explains_little ||
                                 match.verdict == FitVerdict::None || tracking_.isLost());
}

/// How far from the guess the vehicle may be.
double Slam::mostMisled_m(const Pose2& pose_map_init) const
{
    if (!hasOdometry() || tracking_.isLost()) return std::numeric_limits<double>::infinity();
    const double way_m =
        std::hypot(pose_map_init.x - matched_at_.x, pose_map_init.y - matched_at_.y);
    return kSlip_m + kSlipShare * way_m;
}

void Slam::searchAround(const Pose2& pose_map_init, Match& match)
{
    report_.searched = true;
    Pose2 pose_map_found;
    {
        const StepTimer timer(report_.times.search_s);
        turn_points(pose_map_init, matched_vehicle_.view(), points_turned_);
        map_.draw(pose_map_init, std::nullopt, trustedBegin(), reference_);
        pose_map_found = search_.search(
            pose_map_init, points_turned_, reference_, tracking_.isLost(),
            mostMisled_m(pose_map_init));
    }
    local_.drop();
    Match found = matchAround(pose_map_found);
    if (isBetterBeside(found, match))
    {
        match = found;
        return;
    }
    // New ground fits badly, too: a match from odometry is given up for a far better one only.
    const double left =
        hasOdometry() && is_match(match.verdict) ? kUnexplainedLeftWithOdometry : 1.0;
    const double enough =
        std::max(options_.search.min_paired_share, 1 - left * (1 - match.fit.paired_share));
    if (found.verdict != FitVerdict::Good || found.fit.paired_share < enough) return;
    match = found;
    match.is_found = true;
}

/// Beside a match from odometry another may be the deeper hollow, as in a fast turn. Without
/// odometry the guess is no better than what is found, and the two are told apart by what they
/// explain.
bool Slam::isBetterBeside(const Match& found, const Match& match) const
{
    const double distance_m = options_.icp.final_pair_distance_m;
    return hasOdometry() && is_match(match.verdict) && is_match(found.verdict) &&
           is_near(found.pose_map_vehicle, match.pose_map_vehicle, kBeside_m, kBeside_rad) &&
           misfit_m2(found.fit, distance_m) < kBetterBeside * misfit_m2(match.fit, distance_m);
}

/// A match that contradicts odometry which has been right so far: as long as the scan fits about as
/// well where odometry says, it stays there. Crowded rooms, and the seams of loops, offer better
/// places now and then; where odometry slips, nothing fits where it says.
void Slam::holdToOdometry(const Pose2& pose_map_init, Match& match)
{
    if (!options_.prealign.hold_to_odometry || !prealignment_.goesByOdometry() ||
        tracking_.isLost() || !is_match(match.verdict))
        return;
    const Pose2 error = between(pose_map_init, match.pose_map_vehicle);
    if (guess_errors_.isUnusual(error))
    {
        const Match held = matchAround(pose_map_init, IcpReach::Near);
        const double distance_m = options_.icp.final_pair_distance_m;
        if (is_match(held.verdict) &&
            misfit_m2(held.fit, distance_m) < kAboutAsWell * misfit_m2(match.fit, distance_m))
        {
            match = held;
            return;
        }
    }
    const Pose2 way = between(prealignment_.last(), pose_map_init);
    const bool stands = std::hypot(way.x, way.y) < kStands_m && std::abs(way.yaw) < kStands_rad;
    if (!match.is_found && !stands) guess_errors_.learn(error);
}
}  // namespace rtob

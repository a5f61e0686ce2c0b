// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/slam/relocaliser.h>
#include <rtob/slam/turned_points.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtob
{
namespace
{
// A rival is given up where it explains this much less than must be explained, or crosses this much
// more than may be crossed.
constexpr double kRivalSlack = 0.2;
// How far a vehicle gets from scan to scan, without odometry.
constexpr double kMostStep_m = 0.8, kMostTurn_rad = 0.6;
constexpr std::size_t kScanSearchPoints = 100;
// A scan that reaches less far, as of a covered laser, tells no place from another.
constexpr float kLeastReach_m = 1.0F;
// Refined places that are nearer have become one.
constexpr double kSame_m = 0.3, kSame_rad = 0.1;
// Tracking that slipped, as where people hide the walls, comes back from nearer by itself, and of a
// corridor's two directions the odd scan takes the wrong one.
constexpr double kCarried_m = 2.5;
// Scans in a row that must fit another place than the tracked one.
constexpr int kConfirmedElsewhere = 2;
// A scan that fits so well where the search left places out is a scan of anywhere.
constexpr double kAnywhere = 0.98;
constexpr std::size_t kMostRefined = 16, kMostFollowed = 12;
// Of the alignment that refines a place.
constexpr int kLookIterations = 60;
constexpr double kLookStep_m = 0.0005;

/// A place found on a raster is far from where the scan fits, and along a corridor the steps
/// towards it are small.
IcpOptions to_the_end(IcpOptions icp)
{
    icp.iterations = std::max(icp.iterations, kLookIterations);
    icp.stop_step_m = std::min(icp.stop_step_m, kLookStep_m);
    return icp;
}

bool is_carried(const Pose2& from, const Pose2& to)
{
    return std::hypot(from.x - to.x, from.y - to.y) >= kCarried_m;
}
}  // namespace

void RelocaliseOptions::validate() const
{
    require(min_score > 0 && min_score <= 1, "min_score", min_score, "in (0, 1]");
    require(
        min_explained_share > 0 && min_explained_share <= 1, "min_explained_share",
        min_explained_share, "in (0, 1]");
    require(
        max_through_share >= 0 && max_through_share <= 1, "max_through_share", max_through_share,
        "in [0, 1]");
    require(min_lead > 0, "min_lead", min_lead, "> 0");
    require(confirm_scans >= 1, "confirm_scans", confirm_scans, ">= 1");
    require(max_scans >= confirm_scans, "max_scans", max_scans, ">= confirm_scans");
    require(looks_per_scan >= 100'000, "looks_per_scan", looks_per_scan, ">= 100000");
}

Relocaliser::Relocaliser(const RelocaliseOptions& options, const IcpOptions& icp)
    : options_(options), check_(to_the_end(icp)), icp_(icp)
{
    options_.validate();
    places_.reserve(GlobalSearch::kMostCandidates + 1);
}

bool Relocaliser::tellsPlaces(const Points& points_vehicle)
{
    for (std::size_t i = 0; i < points_vehicle.size(); ++i)
        if (std::hypot(points_vehicle.x[i], points_vehicle.y[i]) >= kLeastReach_m) return true;
    return false;
}

void Relocaliser::restart()
{
    places_.clear();
    searching_ = false;
    scans_followed_ = 0;
}

void Relocaliser::learn(const MapView& map)
{
    restart();
    raster_.draw(map.points_map, map.scans);
    raster_ready_ = true;
}

std::optional<PlaceEvidence> Relocaliser::take(
    const MapView& map, const Points& points_vehicle, const std::optional<Pose2>& pose_prev_now,
    const std::optional<Pose2>& pose_map_tracked)
{
    if (!raster_ready_) learn(map);
    if (!tellsPlaces(points_vehicle))
    {
        restart();
        return std::nullopt;
    }
    const bool is_under_way = searching_ || !places_.empty();
    const Pose2 motion = !is_under_way   ? Pose2{}
                         : pose_prev_now ? *pose_prev_now
                                         : motionTo(points_vehicle);
    points_prev_ = points_vehicle;
    if (!places_.empty())
        follow(points_vehicle, motion);
    else if (search(points_vehicle, motion))
    {
        if (pose_map_tracked) places_.emplace_back().evidence.pose_map_vehicle = *pose_map_tracked;
        refine(points_vehicle);
    }
    else
        return std::nullopt;
    weed();
    return decide();
}

/// @return whether the search is over and its places, moved on to this scan, wait to be followed.
/// After one that tells nothing, the next scan is searched for.
bool Relocaliser::search(const Points& points_vehicle, const Pose2& pose_prev_now)
{
    if (!searching_)
    {
        search_.begin(raster_, points_vehicle.view(), options_.min_score);
        pose_searched_now_ = {};
        searching_ = true;
    }
    else
        pose_searched_now_ = compose(pose_searched_now_, pose_prev_now);
    if (!search_.advance(raster_, static_cast<std::size_t>(options_.looks_per_scan))) return false;
    searching_ = false;
    scans_followed_ = 0;
    if (search_.mostLeftOut() >= kAnywhere) return false;
    for (const PlaceCandidate& candidate : search_.candidates())
        places_.emplace_back().evidence.pose_map_vehicle =
            compose(candidate.pose_map_vehicle, pose_searched_now_);
    return true;
}

/// Without odometry: the motion since the last scan, by looking for this one in it.
Pose2 Relocaliser::motionTo(const Points& points_vehicle)
{
    const std::size_t stride = points_vehicle.size() / kScanSearchPoints + 1;
    points_thinned_.clear();
    for (std::size_t i = 0; i < points_vehicle.size(); i += stride)
        points_thinned_.add(points_vehicle.x[i], points_vehicle.y[i]);
    const SearchWindow window{kMostStep_m, kMostTurn_rad};
    const Pose2 found =
        scan_search_.search(points_thinned_.view(), points_prev_.view(), window).correction;
    // ICP starts from there: the new points turned, the old ones seen from the new place.
    turn_points({0, 0, found.yaw}, points_vehicle.view(), points_turned_);
    points_shifted_.clear();
    for (std::size_t i = 0; i < points_prev_.size(); ++i)
        points_shifted_.add(
            points_prev_.x[i] - static_cast<float>(found.x),
            points_prev_.y[i] - static_cast<float>(found.y));
    const IcpResult fit = icp_.align(points_turned_.view(), points_shifted_.view());
    return fit.pairs == 0 ? found : apply_correction(found, fit.correction);
}

void Relocaliser::follow(const Points& points_vehicle, const Pose2& pose_prev_now)
{
    ++scans_followed_;
    for (Place& place : places_)
        add(check_.look(
                raster_, points_vehicle, compose(place.evidence.pose_map_vehicle, pose_prev_now)),
            place);
}

/// The first scan: a search leaves its places rough, so the best of them are looked around.
void Relocaliser::refine(const Points& points_vehicle)
{
    scans_followed_ = 1;
    for (Place& place : places_)
    {
        place.evidence = check_.settle(raster_, points_vehicle, place.evidence.pose_map_vehicle);
        place.log_misfit = place.evidence.logMisfit();
    }
    sortPlaces();
    places_.resize(std::min(places_.size(), kMostRefined));
    for (Place& place : places_)
    {
        const Pose2 pose_map_rough = place.evidence.pose_map_vehicle;
        place = Place();
        add(check_.lookAround(raster_, points_vehicle, pose_map_rough), place);
    }
}

/// What the next scan says.
void Relocaliser::add(const PlaceEvidence& evidence, Place& place) const
{
    place.evidence = evidence;
    place.log_misfit += evidence.logMisfit();
    const bool is_good = evidence.on_points_share >= options_.min_explained_share &&
                         evidence.through_share <= options_.max_through_share;
    place.good_in_a_row = is_good ? place.good_in_a_row + 1 : 0;
}

/// The best first.
void Relocaliser::sortPlaces()
{
    std::sort(
        places_.begin(), places_.end(),
        [](const Place& a, const Place& b) { return a.log_misfit < b.log_misfit; });
}

/// Gives up places that do not explain the scan, all but the best of those that have become one,
/// and those beyond a dozen.
void Relocaliser::weed()
{
    sortPlaces();
    std::size_t kept = 0;
    for (std::size_t k = 0; k < places_.size() && kept < kMostFollowed; ++k)
    {
        const Place& place = places_[k];
        const Pose2& pose = place.evidence.pose_map_vehicle;
        const bool explains =
            place.evidence.on_points_share >= options_.min_explained_share - kRivalSlack &&
            place.evidence.through_share <= options_.max_through_share + kRivalSlack;
        const bool is_known = std::any_of(
            places_.begin(), places_.begin() + static_cast<std::ptrdiff_t>(kept),
            [&](const Place& other)
            { return is_near(other.evidence.pose_map_vehicle, pose, kSame_m, kSame_rad); });
        if (explains && !is_known) places_[kept++] = place;
    }
    places_.resize(kept);
}

std::optional<PlaceEvidence> Relocaliser::decide()
{
    if (places_.empty()) return std::nullopt;
    const Place& best = places_.front();
    const bool is_alone =
        places_.size() == 1 || places_[1].log_misfit - best.log_misfit >= options_.min_lead;
    if (is_alone && best.good_in_a_row >= options_.confirm_scans) return best.evidence;
    if (scans_followed_ >= options_.max_scans) restart();
    return std::nullopt;
}

PlaceLead Relocaliser::leadOver(const Pose2& pose_map_tracked, double log_misfit) const
{
    const auto is_tracked = [&](const Place& place)
    { return is_near(place.evidence.pose_map_vehicle, pose_map_tracked, kSame_m, kSame_rad); };
    const auto best = std::find_if_not(places_.begin(), places_.end(), is_tracked);
    if (best == places_.end() || best->good_in_a_row < kConfirmedElsewhere ||
        !is_carried(pose_map_tracked, best->evidence.pose_map_vehicle))
        return {};
    double tracked = log_misfit, others = std::numeric_limits<double>::infinity();
    for (const Place& place : places_)
        if (is_tracked(place))
            tracked = std::min(tracked, place.log_misfit);
        else if (is_carried(best->evidence.pose_map_vehicle, place.evidence.pose_map_vehicle))
            others = std::min(others, place.log_misfit);
    return {tracked - best->log_misfit, others - best->log_misfit};
}

bool Relocaliser::hasRival(const Pose2& pose_map_tracked) const
{
    return searching_ ||
           std::any_of(
               places_.begin(), places_.end(),
               [&](const Place& place)
               {
                   return place.good_in_a_row > 0 &&
                          is_carried(pose_map_tracked, place.evidence.pose_map_vehicle);
               });
}
}  // namespace rtob

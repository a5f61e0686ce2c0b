// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/fit_gate.h>
#include <rtob/slam/place_check.h>
#include <rtob/slam/turned_points.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
// What lies nearer to the laser or to the beam's end may be the vehicle's edge, or noise.
constexpr double kNearLaser_m = 0.5, kNearEnd_m = 0.5;
constexpr std::size_t kEveryBeam = 2;
// How far around a scan's points the map is looked at.
constexpr double kMargin_m = 1.0;
// Scans come to rest some 20 to 50 cm beside the true place along walls with a pattern.
constexpr double kRing_m = 0.3;
constexpr int kRingPlaces = 6;
constexpr double kTwoPi = 6.28318530717958648;
// How far off the points of a raster are from a scan that was taken there: their cells are 0.1 m.
constexpr double kInPlace_m = 0.032;
// How far off a point without a neighbour counts.
constexpr double kUnpaired_m = 0.2;

void weigh(const MapRaster& raster, const PointsView& points_vehicle, PlaceEvidence& evidence)
{
    evidence.on_points_share = share_on_points(raster, points_vehicle, evidence.pose_map_vehicle);
    evidence.through_share = share_through_walls(raster, points_vehicle, evidence.pose_map_vehicle);
}
}  // namespace

double PlaceEvidence::logMisfit() const
{
    return std::log(misfit_m2(fit, kUnpaired_m));
}

double PlaceEvidence::logMisfit(double explained_share)
{
    PlaceEvidence place;
    place.fit.paired_share = explained_share;
    place.fit.mean_squared_error = kInPlace_m * kInPlace_m;
    return place.logMisfit();
}

PlaceEvidence PlaceCheck::settle(
    const MapRaster& raster, const Points& points_vehicle, const Pose2& pose_map_guess)
{
    prepare(raster, points_vehicle, pose_map_guess);
    return refine(pose_map_guess, {0, 0});
}

PlaceEvidence PlaceCheck::look(
    const MapRaster& raster, const Points& points_vehicle, const Pose2& pose_map_guess)
{
    PlaceEvidence evidence = settle(raster, points_vehicle, pose_map_guess);
    weigh(raster, points_vehicle.view(), evidence);
    return evidence;
}

PlaceEvidence PlaceCheck::lookAround(
    const MapRaster& raster, const Points& points_vehicle, const Pose2& pose_map_guess)
{
    PlaceEvidence best = settle(raster, points_vehicle, pose_map_guess);
    for (int k = 0; k < kRingPlaces; ++k)
    {
        const double angle = kTwoPi * k / kRingPlaces;
        const PlaceEvidence other =
            refine(pose_map_guess, kRing_m * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
        if (other.logMisfit() < best.logMisfit()) best = other;
    }
    weigh(raster, points_vehicle.view(), best);
    return best;
}

void PlaceCheck::prepare(
    const MapRaster& raster, const Points& points_vehicle, const Pose2& pose_map_guess)
{
    const Box seen_map = turn_points(pose_map_guess, points_vehicle.view(), points_turned_);
    // Made equal to all sides, so that the points come seen from the vehicle.
    const double half_width_m =
        kMargin_m +
        std::max(
            std::max(pose_map_guess.x - seen_map.min_x, seen_map.max_x - pose_map_guess.x),
            std::max(pose_map_guess.y - seen_map.min_y, seen_map.max_y - pose_map_guess.y));
    raster.collect(Box::around(pose_map_guess.x, pose_map_guess.y, half_width_m), points_around_);
    icp_.prepare(points_around_.view(), reference_);
}

PlaceEvidence PlaceCheck::refine(const Pose2& pose_map_guess, const Eigen::Vector2d& from)
{
    PlaceEvidence evidence;
    evidence.fit = icp_.align(points_turned_.view(), reference_, from);
    evidence.pose_map_vehicle = apply_correction(
        {pose_map_guess.x + from.x(), pose_map_guess.y + from.y(), pose_map_guess.yaw},
        evidence.fit.correction);
    return evidence;
}

double share_on_points(
    const MapRaster& raster, const PointsView& points_vehicle, const Pose2& pose_map_vehicle)
{
    const double c = std::cos(pose_map_vehicle.yaw), s = std::sin(pose_map_vehicle.yaw);
    int marks = 0;
    for (std::size_t i = 0; i < points_vehicle.size; ++i)
    {
        const double x = points_vehicle.x[i], y = points_vehicle.y[i];
        marks += raster.mark(
            0, raster.cellX(pose_map_vehicle.x + c * x - s * y),
            raster.cellY(pose_map_vehicle.y + s * x + c * y));
    }
    const double most = MapRaster::kHit * static_cast<double>(points_vehicle.size);
    return most == 0 ? 0 : marks / most;
}

double share_through_walls(
    const MapRaster& raster, const PointsView& points_vehicle, const Pose2& pose_map_vehicle)
{
    const double c = std::cos(pose_map_vehicle.yaw), s = std::sin(pose_map_vehicle.yaw);
    std::size_t beams = 0, through = 0;
    for (std::size_t i = 0; i < points_vehicle.size; i += kEveryBeam)
    {
        const double x = points_vehicle.x[i], y = points_vehicle.y[i];
        const double range_m = std::hypot(x, y);
        if (range_m < kNearLaser_m + kNearEnd_m) continue;
        ++beams;
        const double ux = (c * x - s * y) / range_m, uy = (s * x + c * y) / range_m;
        bool is_through = false;
        for (double at_m = kNearLaser_m; at_m < range_m - kNearEnd_m && !is_through;
             at_m += raster.cell_m())
        {
            const int cell_x = raster.cellX(pose_map_vehicle.x + at_m * ux);
            const int cell_y = raster.cellY(pose_map_vehicle.y + at_m * uy);
            is_through = raster.mark(0, cell_x, cell_y) == MapRaster::kHit &&
                         !raster.isSeen(0, cell_x, cell_y);
        }
        through += is_through;
    }
    return beams == 0 ? 0 : static_cast<double>(through) / static_cast<double>(beams);
}
}  // namespace rtob

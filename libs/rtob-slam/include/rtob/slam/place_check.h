// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>
#include <rtob/core/map_raster.h>
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>

namespace rtob
{
/// What speaks for a scan having been taken at a place of the map, and what against it.
struct PlaceEvidence
{
    Pose2 pose_map_vehicle;  ///< refined
    IcpResult fit;
    double on_points_share = 0;  ///< [0, 1] of the points that fall on the map's, to a cell
    double through_share = 1;    ///< [0, 1] of the beams that pass through what the map has

    /// The logarithm of the mean squared distance: what the scan says against the place.
    [[nodiscard]] double logMisfit() const;
    /// The same of a place that is known to explain a share of the scan as well as any place can.
    [[nodiscard]] static double logMisfit(double explained_share);
};

/// Compares scans with places of a map that is drawn on a raster. Keeps buffers only.
class PlaceCheck
{
 public:
    explicit PlaceCheck(const IcpOptions& icp) : icp_(icp) {}

    /// Refines the pose by ICP, and leaves the shares alone.
    [[nodiscard]] PlaceEvidence settle(
        const MapRaster& raster, const Points& points_vehicle, const Pose2& pose_map_guess);
    /// Refines the pose by ICP, then looks.
    [[nodiscard]] PlaceEvidence look(
        const MapRaster& raster, const Points& points_vehicle, const Pose2& pose_map_guess);
    /// The same from a ring of places around the guess, too: of where they come to rest, the one is
    /// taken whose misfit is the least. For guesses as rough as a search's.
    [[nodiscard]] PlaceEvidence lookAround(
        const MapRaster& raster, const Points& points_vehicle, const Pose2& pose_map_guess);

 private:
    void prepare(
        const MapRaster& raster, const Points& points_vehicle, const Pose2& pose_map_guess);
    /// @param from where ICP begins, seen from the guess
    [[nodiscard]] PlaceEvidence refine(const Pose2& pose_map_guess, const Eigen::Vector2d& from);

    Icp icp_;
    IcpReference reference_;  ///< the map around the guess, seen from there
    Points points_turned_, points_around_;
};

/// [0, 1] of the points that fall into cells with map points; beside one counts half.
[[nodiscard]] double share_on_points(
    const MapRaster& raster, const PointsView& points_vehicle, const Pose2& pose_map_vehicle);

/// [0, 1] of the beams, from the vehicle to the scan's points, that cross cells with map points,
/// through which no scan of the map looked, well before their end.
[[nodiscard]] double share_through_walls(
    const MapRaster& raster, const PointsView& points_vehicle, const Pose2& pose_map_vehicle);
}  // namespace rtob

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

    /// At most 1.
    [[nodiscard]] double strength() const { return on_points_share - 0.5 * through_share; }
};

/// Compares scans with places of a map that is drawn on a raster. Keeps buffers only.
class PlaceCheck
{
 public:
    explicit PlaceCheck(const IcpOptions& icp) : icp_(icp) {}

    /// Refines the pose by ICP, then looks.
    [[nodiscard]] PlaceEvidence look(
        const MapRaster& raster, const Points& points_vehicle, const Pose2& pose_map_guess);

 private:
    Icp icp_;
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

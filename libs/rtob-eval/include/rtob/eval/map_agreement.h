// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>

#include <cstddef>

namespace rtob
{
struct MapAgreementOptions
{
    double cell_m = 0.05;       ///< of each map one point a cell counts, so that no place outweighs
    double tolerance_m = 0.10;  ///< points this near each other are the same wall
    double search_m = 5;        ///< the maps' origins are at most this far apart, in x and in y
};

/// How well one map lies on another one of the same place.
struct MapAgreement
{
    Pose2 pose_reference_estimate;  ///< where the estimate's origin lies on the reference
    std::size_t estimate_cells = 0, reference_cells = 0;
    double estimate_share = 0;   ///< [0, 1] of the estimate's cells, near one of the reference
    double reference_share = 0;  ///< [0, 1] of the reference's cells, near one of the estimate
    double mean_distance_m = 0;  ///< of the estimate's cells that are near
};

/// Lays the estimate onto the reference, whatever way it is turned, and counts what coincides. Both
/// maps may hold what the other vehicle never saw: such parts count as not shared. Throws
/// std::invalid_argument where a map has no points or the options make no sense.
[[nodiscard]] MapAgreement map_agreement(
    const PointsView& points_estimate, const PointsView& points_reference,
    const MapAgreementOptions& options = {});
}  // namespace rtob

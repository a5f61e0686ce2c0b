// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/neighbour_grid.h>
#include <rtob/core/pose2.h>
#include <rtob/core/reference_draw.h>

#include <cstdint>
#include <optional>

namespace rtob
{
/// A number that tells scans apart: FNV-1a over the bits of their points.
[[nodiscard]] std::uint64_t scan_hash(const PointsView& points);

/// The points drawn for one scan, kept as long as that scan is matched. MRPT asks a map for pairs
/// once an iteration and tells it neither the time nor that a new scan has begun, so a scan is
/// known by its hash.
class MatchSample
{
 public:
    /// A neighbour among the drawn points.
    struct Neighbour
    {
        std::size_t drawn;        ///< index into reference()
        double squared_distance;  ///< m^2
    };

    /// Forgets the sample: the map has changed.
    void reset() { hash_.reset(); }
    [[nodiscard]] bool empty() const { return !hash_; }

    /// Whether the sample was drawn for this scan, within max_offset_m of this pose.
    [[nodiscard]] bool isFor(
        std::uint64_t hash, const Pose2& pose_map_vehicle, double max_offset_m) const;

    /// The place to draw the points of another scan into.
    [[nodiscard]] Reference& renew(std::uint64_t hash);
    [[nodiscard]] const Reference& reference() const { return reference_; }

    /// Before nearest(): most radii will be usual_radius_m, none larger than max_radius_m.
    void prepare(double usual_radius_m, double max_radius_m);
    /// The nearest drawn point within the radius of a place in the map.
    [[nodiscard]] std::optional<Neighbour> nearest(
        double x_map, double y_map, double radius_m) const;
    /// To the nearest drawn point however far; infinite when nothing was drawn.
    [[nodiscard]] double squaredDistance(double x_map, double y_map) const;

 private:
    std::optional<std::uint64_t> hash_;
    Reference reference_;
    NeighbourGrid usual_grid_, wide_grid_;
    double usual_radius_m_ = 0, wide_radius_m_ = 0;  ///< 0: not built
};
}  // namespace rtob

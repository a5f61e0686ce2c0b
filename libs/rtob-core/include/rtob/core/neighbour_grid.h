// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <cstdint>
#include <vector>

namespace rtob
{
struct CellTable;

/// Nearest neighbours within a radius, over a small set of points that changes with every scan.
///
/// The points are sorted into square cells of a quarter of the largest radius. The table of cells
/// is small and wraps around, so a reference of any extent costs the same; a far point that shares
/// a cell is told apart by its distance. Exact: tested against brute force.
class NeighbourGrid
{
 public:
    static constexpr std::int32_t kNone = -1;
    static constexpr float kFarthest_m = 1e6f;  ///< nothing is found beyond

    struct Neighbour
    {
        std::int32_t index = kNone;  ///< into the sorted points(), kNone if there is none
        float squared_distance = 0;  ///< m^2
        float squared_gap = 0;       ///< m^2; no other point is nearer than this
    };

    /// Sorts the points into cells. @param usual_radius_m that of most queries: larger ones are
    /// slower.
    /// @param max_per_cell of the points of a cell only the first so many are kept; 0: all. What is
    /// seen a thousand times need not be searched a thousand times.
    void build(const PointsView& points, double usual_radius_m, std::uint32_t max_per_cell = 0);

    /// The nearest point within radius_m; of equally near ones always the same.
    [[nodiscard]] Neighbour nearest(float x, float y, float radius_m) const;

    /// nearest() of each query.
    /// @param radius_m of each query; kLikeBefore: as far as the nearest of the query before
    /// suggests, at most max_radius_m.
    /// @param slack_m how much farther than a known point is looked, so that gaps come out wide.
    void nearestOfEach(
        const PointsView& queries, const float* radius_m, float max_radius_m, float slack_m,
        Neighbour* found) const;
    static constexpr float kLikeBefore = -1;

    /// Sums over points, seen from where they were asked for.
    struct Sums
    {
        float n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    };
    /// The sums over all points within radius_m.
    [[nodiscard]] Sums sumsNear(float x, float y, float radius_m) const;

    /// The points as sorted; Neighbour::index counts these.
    [[nodiscard]] PointsView points() const
    {
        return {sorted_.x.data(), sorted_.y.data(), original_.size()};
    }

    /// How many points there may be without more memory.
    [[nodiscard]] std::size_t capacity() const { return original_.capacity(); }

    /// Where the sorted point stood among those given to build().
    [[nodiscard]] std::size_t original(std::int32_t index) const
    {
        return original_[static_cast<std::size_t>(index)];
    }

 private:
    [[nodiscard]] CellTable table() const;

    float cells_per_metre_ = 1;
    std::int32_t side_ = 1;                  ///< cells in a row of the table, a power of two
    std::vector<std::uint32_t> cell_begin_;  ///< first sorted point of each cell, row by row
    std::vector<std::uint32_t> cell_of_point_;
    std::vector<std::uint32_t> original_;
    Points sorted_;  ///< and some points at infinity, so that lanes may read past the end
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <cmath>
#include <cstdint>
#include <vector>

namespace rtob
{
/// Nearest neighbours within a radius, over a small set of points that changes with every scan.
///
/// The points are sorted into square cells of a quarter of the largest radius. The table of cells
/// is small and wraps around, so a reference of any extent costs the same; a far point that shares
/// a cell is told apart by its distance. Exact: tested against brute force.
class NeighbourGrid
{
 public:
    static constexpr std::int32_t kNone = -1;

    struct Neighbour
    {
        std::int32_t index = kNone;  ///< into the sorted points(), kNone if there is none
        float squared_distance = 0;  ///< m^2
    };

    /// Sorts the points into cells. @param max_radius_m the largest radius that will be asked for.
    void build(const PointsView& points, double max_radius_m);

    /// The nearest point within radius_m <= max_radius_m; of equally near ones the first sorted.
    [[nodiscard]] Neighbour nearest(float x, float y, float radius_m) const;

    /// Calls visit(index) for each point whose cell may hold points within radius_m.
    template <class Visit>
    void forEachNear(float x, float y, float radius_m, Visit&& visit) const;

    /// The points as sorted; Neighbour::index counts these.
    [[nodiscard]] const Points& points() const { return sorted_; }

    /// Where the sorted point stood among those given to build().
    [[nodiscard]] std::size_t original(std::int32_t index) const
    {
        return original_[static_cast<std::size_t>(index)];
    }

 private:
    [[nodiscard]] std::int32_t cellOf(float v) const;

    /// Calls visit(begin, end) for each run of sorted points in the cells around (x, y).
    template <class Visit>
    void forEachRun(float x, float y, float radius_m, Visit&& visit) const;

    float cells_per_metre_ = 1;
    std::int32_t side_ = 1;                  ///< cells in a row of the table, a power of two
    std::vector<std::uint32_t> cell_begin_;  ///< first sorted point of each cell, row by row
    std::vector<std::uint32_t> cell_of_point_;
    std::vector<std::uint32_t> original_;
    Points sorted_;
};

inline std::int32_t NeighbourGrid::cellOf(float v) const
{
    const float cell = v * cells_per_metre_;
    const auto truncated = static_cast<std::int32_t>(cell);
    return truncated - (cell < static_cast<float>(truncated) ? 1 : 0);  // floor, without a call
}

template <class Visit>
void NeighbourGrid::forEachRun(float x, float y, float radius_m, Visit&& visit) const
{
    const std::int32_t x0 = cellOf(x - radius_m), x1 = cellOf(x + radius_m);
    const std::int32_t y0 = cellOf(y - radius_m), y1 = cellOf(y + radius_m);
    const std::int32_t mask = side_ - 1;
    const std::int32_t first = x0 & mask, last = x1 & mask;
    for (std::int32_t row = y0; row <= y1; ++row)
    {
        const std::uint32_t* begin = cell_begin_.data() + (row & mask) * side_;
        if (first <= last)
            visit(begin[first], begin[last + 1]);
        else  // the run crosses the table's edge
        {
            visit(begin[first], begin[side_]);
            visit(begin[0], begin[last + 1]);
        }
    }
}

template <class Visit>
void NeighbourGrid::forEachNear(float x, float y, float radius_m, Visit&& visit) const
{
    forEachRun(
        x, y, radius_m,
        [&](std::uint32_t begin, std::uint32_t end)
        {
            for (std::uint32_t i = begin; i < end; ++i) visit(static_cast<std::int32_t>(i));
        });
}

inline NeighbourGrid::Neighbour NeighbourGrid::nearest(float x, float y, float radius_m) const
{
    // `<` keeps the first of equals; the start value lets a point at exactly the radius in.
    Neighbour best{kNone, std::nextafter(radius_m * radius_m, 1e30f)};
    forEachRun(
        x, y, radius_m,
        [&](std::uint32_t begin, std::uint32_t end)
        {
            for (std::uint32_t i = begin; i < end; ++i)
            {
                const float dx = sorted_.x[i] - x, dy = sorted_.y[i] - y;
                const float d2 = dx * dx + dy * dy;
                const bool nearer = d2 < best.squared_distance;
                best.index = nearer ? static_cast<std::int32_t>(i) : best.index;
                best.squared_distance = nearer ? d2 : best.squared_distance;
            }
        });
    return best;
}
}  // namespace rtob

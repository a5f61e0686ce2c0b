// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
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
    static constexpr float kFarthest_m = 1e6f;  ///< nothing is found beyond

    struct Neighbour
    {
        std::int32_t index = kNone;  ///< into the sorted points(), kNone if there is none
        float squared_distance = 0;  ///< m^2
    };

    /// Sorts the points into cells. @param max_radius_m the largest radius that will be asked for.
    /// @param max_per_cell of the points of a cell only the first so many are kept; 0: all. What is
    /// seen a thousand times need not be searched a thousand times.
    void build(const PointsView& points, double max_radius_m, std::uint32_t max_per_cell = 0);

    /// The nearest point within radius_m <= max_radius_m; of equally near ones always the same.
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
    static constexpr std::int32_t kFewRows = 2;  ///< with so few there is nothing to save

    [[nodiscard]] std::int32_t cellOf(float v) const;

    [[nodiscard]] static float nextAbove(float v);
    void nearestInRow(std::int32_t row, float x, float y, float reach_m, Neighbour& best) const;

    /// Calls visit(begin, end) for the one or two runs of sorted points in the row's cells within
    /// radius_m of x.
    template <class Visit>
    void forEachRunOfRow(std::int32_t row, float x, float radius_m, Visit&& visit) const;

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
void NeighbourGrid::forEachRunOfRow(std::int32_t row, float x, float radius_m, Visit&& visit) const
{
    const std::int32_t mask = side_ - 1;
    const std::int32_t first = cellOf(x - radius_m) & mask, last = cellOf(x + radius_m) & mask;
    const std::uint32_t* begin = cell_begin_.data() + (row & mask) * side_;
    if (first <= last)
        visit(begin[first], begin[last + 1]);
    else  // the run crosses the table's edge
    {
        visit(begin[first], begin[side_]);
        visit(begin[0], begin[last + 1]);
    }
}

template <class Visit>
void NeighbourGrid::forEachNear(float x, float y, float radius_m, Visit&& visit) const
{
    const std::int32_t end_row = cellOf(y + radius_m) + 1;
    for (std::int32_t row = cellOf(y - radius_m); row < end_row; ++row)
        forEachRunOfRow(
            row, x, radius_m,
            [&](std::uint32_t begin, std::uint32_t end)
            {
                for (std::uint32_t i = begin; i < end; ++i) visit(static_cast<std::int32_t>(i));
            });
}

/// The next larger float; v >= 0.
inline float NeighbourGrid::nextAbove(float v)
{
    std::uint32_t bits = 0;
    std::memcpy(&bits, &v, sizeof(bits));
    ++bits;
    std::memcpy(&v, &bits, sizeof(bits));
    return v;
}

inline void NeighbourGrid::nearestInRow(
    std::int32_t row, float x, float y, float reach_m, Neighbour& best) const
{
    forEachRunOfRow(
        row, x, reach_m,
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
}

inline NeighbourGrid::Neighbour NeighbourGrid::nearest(float x, float y, float radius_m) const
{
    // Such cells have no number; this is also true of what is no number.
    if (!(std::abs(x) < kFarthest_m && std::abs(y) < kFarthest_m)) return {};
    // `<` keeps the first of equals; the start value lets a point at exactly the radius in.
    Neighbour best{kNone, nextAbove(radius_m * radius_m)};
    std::int32_t low = cellOf(y - radius_m), high = cellOf(y + radius_m);
    if (high - low <= kFewRows)
    {
        for (std::int32_t row = low; row <= high; ++row) nearestInRow(row, x, y, radius_m, best);
        return best;
    }
    const std::int32_t middle = cellOf(y);
    float reach_m = radius_m;
    const auto look = [&](std::int32_t row)
    {
        const std::int32_t before = best.index;
        nearestInRow(row, x, y, reach_m, best);
        if (best.index == before) return;
        // A little more than the distance, so that rounding loses nothing.
        reach_m = std::min(radius_m, std::sqrt(best.squared_distance) * 1.00001f);
        low = cellOf(y - reach_m);
        high = cellOf(y + reach_m);
    };
    // Outwards from the middle row: what is found there saves the rows and cells farther out.
    look(middle);
    for (std::int32_t k = 1; middle - k >= low || middle + k <= high; ++k)  // a few at most
    {
        if (middle + k <= high) look(middle + k);
        if (middle - k >= low) look(middle - k);
    }
    return best;
}
}  // namespace rtob

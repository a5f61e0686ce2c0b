// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/neighbour_grid.h>
#include <algorithm>
#include <limits>
#include <stdexcept>

namespace rtob
{
namespace
{
constexpr double kCellsPerRadius = 8;
constexpr std::size_t kCellsPerPoint = 4;
constexpr std::uint32_t kDropped = std::numeric_limits<std::uint32_t>::max();

// Enough cells that few share one, and more cells in a row than a query is wide.
std::int32_t table_side(std::size_t points)
{
    std::int32_t side = 64;
    while (static_cast<std::size_t>(side) * static_cast<std::size_t>(side) <
           kCellsPerPoint * points)
        side *= 2;
    return side;
}
}  // namespace

void NeighbourGrid::build(const PointsView& points, double max_radius_m, std::uint32_t max_per_cell)
{
    if (!(max_radius_m > 0))
        throw std::invalid_argument("NeighbourGrid::build: max_radius_m must be > 0");
    cells_per_metre_ = static_cast<float>(kCellsPerRadius / max_radius_m);
    side_ = table_side(points.size);
    const std::int32_t mask = side_ - 1;

    // Counting sort: count, sum up, place backwards.
    cell_begin_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) + 1, 0);
    cell_of_point_.resize(points.size);
    for (std::size_t i = 0; i < points.size; ++i)
    {
        const auto cell = static_cast<std::uint32_t>(
            (cellOf(points.y[i]) & mask) * side_ + (cellOf(points.x[i]) & mask));
        const bool is_full = max_per_cell > 0 && cell_begin_[cell] == max_per_cell;
        cell_of_point_[i] = is_full ? kDropped : cell;
        if (!is_full) ++cell_begin_[cell];
    }
    std::uint32_t end = 0;
    for (auto& begin : cell_begin_) begin = (end += begin);
    sorted_.reserve(points.size);  // how many are kept changes from draw to draw
    original_.reserve(points.size);
    sorted_.x.resize(end);
    sorted_.y.resize(end);
    original_.resize(end);
    for (std::size_t i = points.size; i-- > 0;)
    {
        if (cell_of_point_[i] == kDropped) continue;
        const std::uint32_t place = --cell_begin_[cell_of_point_[i]];
        sorted_.x[place] = points.x[i];
        sorted_.y[place] = points.y[i];
        original_[place] = static_cast<std::uint32_t>(i);
    }
}
}  // namespace rtob

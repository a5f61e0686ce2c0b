// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/neighbour_grid.h>
#include <algorithm>
#include <stdexcept>

namespace rtob
{
namespace
{
constexpr double kCellsPerRadius = 8;
constexpr std::size_t kCellsPerPoint = 4;

// Enough cells that few share one, and more cells in a row than a query is wide.
std::int32_t table_side(std::size_t points)
{
    std::int32_t side = 32;
    while (static_cast<std::size_t>(side) * static_cast<std::size_t>(side) <
           kCellsPerPoint * points)
        side *= 2;
    return side;
}
}  // namespace

void NeighbourGrid::build(const PointsView& points, double max_radius_m)
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
        cell_of_point_[i] = cell;
        ++cell_begin_[cell];
    }
    std::uint32_t end = 0;
    for (auto& begin : cell_begin_) begin = (end += begin);
    sorted_.x.resize(points.size);
    sorted_.y.resize(points.size);
    original_.resize(points.size);
    for (std::size_t i = points.size; i-- > 0;)
    {
        const std::uint32_t place = --cell_begin_[cell_of_point_[i]];
        sorted_.x[place] = points.x[i];
        sorted_.y[place] = points.y[i];
        original_[place] = static_cast<std::uint32_t>(i);
    }
}
}  // namespace rtob

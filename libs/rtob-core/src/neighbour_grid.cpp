// SPDX-License-Identifier: BSD-3-Clause
#include "neighbour_search.h"

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

void NeighbourGrid::build(
    const PointsView& points, double usual_radius_m, std::uint32_t max_per_cell)
{
    if (!(usual_radius_m > 0))
        throw std::invalid_argument("NeighbourGrid::build: usual_radius_m must be > 0");
    cells_per_metre_ = static_cast<float>(kCellsPerRadius / usual_radius_m);
    side_ = table_side(points.size);
    const std::int32_t mask = side_ - 1;
    const CellTable cells = table();

    // Counting sort: count, sum up, place backwards.
    cell_begin_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) + 1, 0);
    cell_of_point_.resize(points.size);
    for (std::size_t i = 0; i < points.size; ++i)
    {
        const auto cell = static_cast<std::uint32_t>(
            (cell_of(cells, points.y[i]) & mask) * side_ + (cell_of(cells, points.x[i]) & mask));
        const bool is_full = max_per_cell > 0 && cell_begin_[cell] == max_per_cell;
        cell_of_point_[i] = is_full ? kDropped : cell;
        if (!is_full) ++cell_begin_[cell];
    }
    std::uint32_t end = 0;
    for (auto& begin : cell_begin_) begin = (end += begin);
    // How many are kept changes from draw to draw.
    sorted_.reserve(points.size + kLanes);
    original_.reserve(points.size);
    original_.resize(end);
    for (auto* column : {&sorted_.x, &sorted_.y})
    {
        column->resize(end);
        column->resize(end + kLanes, std::numeric_limits<float>::infinity());
    }
    for (std::size_t i = points.size; i-- > 0;)
    {
        if (cell_of_point_[i] == kDropped) continue;
        const std::uint32_t place = --cell_begin_[cell_of_point_[i]];
        sorted_.x[place] = points.x[i];
        sorted_.y[place] = points.y[i];
        original_[place] = static_cast<std::uint32_t>(i);
    }
}

void NeighbourGrid::nearestOfEach(
    const PointsView& queries, const float* radius_m, float usual_radius_m, float slack_m,
    Neighbour* found) const
{
    search_neighbours(table(), queries, radius_m, usual_radius_m, slack_m, found);
}

NeighbourGrid::Sums NeighbourGrid::sumsNear(float x, float y, float radius_m) const
{
    Sums sums;
    sum_neighbours(table(), x, y, radius_m, sums);
    return sums;
}

CellTable NeighbourGrid::table() const
{
    return {sorted_.x.data(), sorted_.y.data(), cell_begin_.data(), side_, cells_per_metre_};
}

NeighbourGrid::Neighbour NeighbourGrid::nearest(float x, float y, float radius_m) const
{
    Neighbour found;
    nearestOfEach({&x, &y, 1}, &radius_m, radius_m, 0, &found);
    return found;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "lanes.h"

#include <rtob/core/neighbour_grid.h>

namespace rtob
{
/// Points sorted into a table of cells that wraps around; kLanes may be read past the end.
struct CellTable
{
    const float *x, *y;
    const std::uint32_t* cell_begin;  ///< row by row, and one more
    std::int32_t side;                ///< a power of two
    float cells_per_metre;
};

/// The number of a cell in its row or column, before the table wraps around.
RTOB_INLINE std::int32_t cell_of(const CellTable& table, float v)
{
    const float cell = v * table.cells_per_metre;
    const auto truncated = static_cast<std::int32_t>(cell);
    return truncated - (cell < static_cast<float>(truncated) ? 1 : 0);  // floor, without a call
}

/// What NeighbourGrid::sumsNear() does.
void sum_neighbours(
    const CellTable& table, float x, float y, float radius_m, NeighbourGrid::Sums& sums);

/// What NeighbourGrid::nearestOfEach() does.
void search_neighbours(
    const CellTable& table, const PointsView& queries, const float* radius_m, float max_radius_m,
    float slack_m, NeighbourGrid::Neighbour* found);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/line_field.h>
#include <rtob/core/neighbour_grid.h>
#include <rtob/core/points.h>

namespace rtob
{
/// Reference points made ready for alignments: sorted into cells, their lines fitted when first
/// asked for. Several scans may be aligned against one.
class IcpReference
{
 public:
    /// @param max_radius_m the largest pair distance that will be asked for.
    /// @param cell_points kept of each cell, see NeighbourGrid::build().
    void build(
        const PointsView& points, double max_radius_m, std::uint32_t cell_points,
        double line_radius_m)
    {
        grid_.build(points, max_radius_m, cell_points);
        lines_.reset(grid_, line_radius_m);
    }

    [[nodiscard]] const NeighbourGrid& grid() const { return grid_; }
    [[nodiscard]] const LineField::Line& line(std::int32_t index)
    {
        return lines_.at(grid_, index);
    }

 private:
    NeighbourGrid grid_;
    LineField lines_;
};
}  // namespace rtob

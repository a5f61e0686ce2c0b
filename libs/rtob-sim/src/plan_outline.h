// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/sim/shape.h>

#include <string>
#include <vector>

namespace rtob::sim
{
/// Cells that are occupied or not, row by row, the lowest row first.
struct Raster
{
    std::size_t width = 0, height = 0;
    double resolution_m = 0;
    std::vector<bool> occupied;

    [[nodiscard]] bool at(std::size_t column, std::size_t row) const
    {
        return occupied[row * width + column];
    }
};

/// The exact border between occupied and other cells, in segments as long as they go. The origin is
/// the raster's lower left corner.
[[nodiscard]] std::vector<Shape> outline_of(const Raster& raster);

struct Plan
{
    std::vector<Shape> outline;
    Point2 corner_map;  ///< its lower left corner, where the file tells
};

/// Reads a picture, where dark is wall (its resolution must be given), or an MRPT grid map
/// (.gridmap, .gridmap.gz), which brings its own resolution. Throws std::runtime_error.
[[nodiscard]] Plan read_plan_file(const std::string& file, double resolution_m);
}  // namespace rtob::sim

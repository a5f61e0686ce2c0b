// SPDX-License-Identifier: BSD-3-Clause
#include "plan_outline.h"

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include <filesystem>
#include <stdexcept>

namespace rtob::sim
{
namespace
{
using mrpt::maps::COccupancyGridMap2D;

/// Along one line of the raster: calls add(from, to) for each run where is_border(i) holds.
template <class IsBorder, class Add>
void for_runs(std::size_t count, IsBorder&& is_border, Add&& add)
{
    std::size_t start = 0;
    bool in_run = false;
    for (std::size_t i = 0; i <= count; ++i)
    {
        const bool border = i < count && is_border(i);
        if (border && !in_run) start = i;
        if (!border && in_run) add(start, i);
        in_run = border;
    }
}

COccupancyGridMap2D read_picture(const std::string& file, double resolution_m)
{
    if (resolution_m <= 0) throw std::runtime_error("a picture needs resolution_m, metres a pixel");
    COccupancyGridMap2D grid;
    if (!grid.loadFromBitmapFile(file, static_cast<float>(resolution_m), {0, 0}))
        throw std::runtime_error(file + " is not a picture");
    return grid;
}

COccupancyGridMap2D read_grid_map(const std::string& file)
{
    try
    {
        mrpt::io::CFileGZInputStream stream(file);
        auto archive = mrpt::serialization::archiveFrom(stream);
        COccupancyGridMap2D grid;
        archive >> grid;
        return grid;
    }
    catch (const std::exception&)
    {
        throw std::runtime_error(file + " is not a grid map of MRPT (COccupancyGridMap2D)");
    }
}

bool is_grid_map(const std::string& file)
{
    return file.find(".gridmap") != std::string::npos;
}

Raster raster_of(const COccupancyGridMap2D& grid)
{
    constexpr float unsure = 0.5F;  // grid maps hold how likely a cell is free; unknown is 0.5
    Raster raster;
    raster.width = grid.getSizeX();
    raster.height = grid.getSizeY();
    raster.resolution_m = grid.getResolution();
    raster.occupied.reserve(raster.width * raster.height);
    for (int row = 0; row < static_cast<int>(raster.height); ++row)
        for (int column = 0; column < static_cast<int>(raster.width); ++column)
            raster.occupied.push_back(grid.getCell(column, row) < unsure - 0.05F);
    return raster;
}
}  // namespace

std::vector<Shape> outline_of(const Raster& raster)
{
    std::vector<Shape> outline;
    const auto corner = [&](std::size_t column, std::size_t row)
    {
        return Point2{
            static_cast<double>(column) * raster.resolution_m,
            static_cast<double>(row) * raster.resolution_m};
    };
    // The border above row - 1 and below row; outside the raster nothing is occupied.
    for (std::size_t row = 0; row <= raster.height; ++row)
        for_runs(
            raster.width,
            [&](std::size_t column)
            {
                const bool below = row > 0 && raster.at(column, row - 1);
                return below != (row < raster.height && raster.at(column, row));
            },
            [&](std::size_t from, std::size_t to) {
                outline.emplace_back(Segment{corner(from, row), corner(to, row)});
            });
    for (std::size_t column = 0; column <= raster.width; ++column)
        for_runs(
            raster.height,
            [&](std::size_t row)
            {
                const bool left = column > 0 && raster.at(column - 1, row);
                return left != (column < raster.width && raster.at(column, row));
            },
            [&](std::size_t from, std::size_t to) {
                outline.emplace_back(Segment{corner(column, from), corner(column, to)});
            });
    return outline;
}

Plan read_plan_file(const std::string& file, double resolution_m)
{
    if (!std::filesystem::is_regular_file(file)) throw std::runtime_error("no such file: " + file);
    const bool has_own_scale = is_grid_map(file);
    const auto grid = has_own_scale ? read_grid_map(file) : read_picture(file, resolution_m);
    Plan plan{outline_of(raster_of(grid)), {}};
    if (has_own_scale) plan.corner_map = {grid.getXMin(), grid.getYMin()};
    if (plan.outline.empty()) throw std::runtime_error(file + " shows no walls: nothing is dark");
    return plan;
}
}  // namespace rtob::sim

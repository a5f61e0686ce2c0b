// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/map_raster.h>
#include <algorithm>
#include <cmath>

#include "raster_pyramid.h"

namespace rtob
{
namespace
{
// No more is looked at, however large the map: the points are taken evenly.
constexpr std::size_t kMostPoints = 1 << 20;
constexpr std::size_t kMostRays = 1 << 17;

std::size_t stride_for(std::size_t size, std::size_t most)
{
    return std::max<std::size_t>(1, (size + most - 1) / most);
}

/// As vector::assign(), with room to spare, so that memory grows seldom.
template <class Value>
void assign(std::vector<Value>& values, std::size_t count, Value value)
{
    if (values.capacity() < count) values.reserve(count + count / 2);
    values.assign(count, value);
}
}  // namespace

void MapRaster::draw(const PointsView& points_map, const ScanTable& scans)
{
    width_ = height_ = 0;
    if (points_map.size == 0) return;
    layOut(points_map);
    markPoints(points_map);
    markNear();
    markSeen(points_map, scans);
    for (Levels* levels : {&marks_, &seen_})
        draw_pyramid(levels->data(), levels->size(), width_, height_);
}

int MapRaster::cellOf(double from_edge_m) const
{
    // Far outside is outside, too, where an int would not hold it.
    constexpr double most = 1 << 24;
    return static_cast<int>(std::floor(std::clamp(from_edge_m / cell_m_, -most, most)));
}

void MapRaster::layOut(const PointsView& points_map)
{
    const auto [low_x, high_x] = std::minmax_element(points_map.x, points_map.x + points_map.size);
    const auto [low_y, high_y] = std::minmax_element(points_map.y, points_map.y + points_map.size);
    const double size_x = *high_x - *low_x, size_y = *high_y - *low_y;
    const auto cells = [](double length_m, double cell_m)
    { return std::floor(length_m / cell_m) + 3; };  // an empty row on each side
    cell_m_ = kFinestCell_m;
    while (cells(size_x, cell_m_) * cells(size_y, cell_m_) > static_cast<double>(kMaxCells))
        cell_m_ *= 1.25;
    min_x_ = *low_x - cell_m_;
    min_y_ = *low_y - cell_m_;
    width_ = static_cast<int>(cells(size_x, cell_m_));
    height_ = static_cast<int>(cells(size_y, cell_m_));
    const std::size_t count = index(0, height_);
    for (Levels* levels : {&marks_, &seen_})
        for (auto& level : *levels) assign(level, count, std::uint8_t{0});
    assign(mean_of_cell_, count, kNoMean);
    means_.clear();
}

void MapRaster::markPoints(const PointsView& points_map)
{
    const std::size_t stride = stride_for(points_map.size, kMostPoints);
    for (std::size_t i = 0; i < points_map.size; i += stride)
    {
        const double x = points_map.x[i] - min_x_, y = points_map.y[i] - min_y_;
        const std::size_t cell = index(cellOf(x), cellOf(y));
        marks_[0][cell] = kHit;
        if (mean_of_cell_[cell] == kNoMean)
        {
            mean_of_cell_[cell] = static_cast<std::uint32_t>(means_.size());
            means_.emplace_back();
        }
        Mean& mean = means_[mean_of_cell_[cell]];
        mean.count += 1;
        mean.x += (static_cast<float>(x) - mean.x) / mean.count;
        mean.y += (static_cast<float>(y) - mean.y) / mean.count;
    }
}

void MapRaster::markNear()
{
    for (int y = 1; y + 1 < height_; ++y)
        for (int x = 1; x + 1 < width_; ++x)
        {
            if (marks_[0][index(x, y)] != kHit) continue;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                {
                    auto& cell = marks_[0][index(x + dx, y + dy)];
                    cell = std::max(cell, static_cast<std::uint8_t>(kNear));
                }
        }
}

void MapRaster::markSeen(const PointsView& points_map, const ScanTable& scans)
{
    const std::size_t stride = stride_for(points_map.size, kMostRays);
    for (std::size_t k = 0; k < scans.size(); ++k)
    {
        // The same share of every scan, not the same of its beams.
        const std::uint64_t first = (scans.firstPoint(k) + stride - 1) / stride * stride;
        for (std::uint64_t i = first; i < scans.firstPoint(k + 1); i += stride)
            markRay(scans.x(k), scans.y(k), points_map.x[i], points_map.y[i]);
    }
}

/// In steps of a cell, the cell with the point left out.
void MapRaster::markRay(double from_x, double from_y, double to_x, double to_y)
{
    const double way_x = (to_x - from_x) / cell_m_, way_y = (to_y - from_y) / cell_m_;
    const double length = std::hypot(way_x, way_y);  // [cells]
    const int steps = static_cast<int>(length);
    if (steps == 0) return;
    const double step_x = way_x / length, step_y = way_y / length;
    double x = (from_x - min_x_) / cell_m_, y = (from_y - min_y_) / cell_m_;
    for (int step = 0; step < steps; ++step, x += step_x, y += step_y)
        if (x >= 0 && y >= 0 && x < width_ && y < height_)
            seen_[0][index(static_cast<int>(x), static_cast<int>(y))] = 1;
}

void MapRaster::collect(const Box& box_map, Points& points) const
{
    points.clear();
    const double middle_x = (box_map.min_x + box_map.max_x) / 2 - min_x_;
    const double middle_y = (box_map.min_y + box_map.max_y) / 2 - min_y_;
    const int begin_x = std::max(0, cellX(box_map.min_x));
    const int end_x = std::min(width_, cellX(box_map.max_x) + 1);
    const int end_y = std::min(height_, cellY(box_map.max_y) + 1);
    for (int y = std::max(0, cellY(box_map.min_y)); y < end_y; ++y)
        for (int x = begin_x; x < end_x; ++x)
        {
            const std::uint32_t mean = mean_of_cell_[index(x, y)];
            if (mean == kNoMean) continue;
            points.add(
                means_[mean].x - static_cast<float>(middle_x),
                means_[mean].y - static_cast<float>(middle_y));
        }
}
}  // namespace rtob

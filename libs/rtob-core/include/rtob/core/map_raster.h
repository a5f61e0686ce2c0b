// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/core/scan_table.h>
#include <array>
#include <cstdint>
#include <vector>

namespace rtob
{
/// A whole map drawn on a grid, with coarser and coarser grids over it: what a search through all
/// of a map looks at. Made once a map; size and cost are bounded, a larger map gets larger cells.
class MapRaster
{
 public:
    static constexpr int kLevels = 6;          ///< the coarsest looks 32 cells ahead
    static constexpr int kHit = 4, kNear = 2;  ///< a map point here, and in a cell beside
    static constexpr double kFinestCell_m = 0.1;
    static constexpr std::size_t kMaxCells = 1 << 21;

    /// Draws the map's points, and what its scans saw to be free.
    void draw(const PointsView& points_map, const ScanTable& scans);

    [[nodiscard]] bool empty() const { return width_ == 0; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] double cell_m() const { return cell_m_; }

    /// The cell of a place in map; it may lie outside.
    [[nodiscard]] int cellX(double x) const { return cellOf(x - min_x_); }
    [[nodiscard]] int cellY(double y) const { return cellOf(y - min_y_); }
    /// The middle of a cell, in map.
    [[nodiscard]] double middleX(int x) const { return min_x_ + (x + 0.5) * cell_m_; }
    [[nodiscard]] double middleY(int y) const { return min_y_ + (y + 0.5) * cell_m_; }

    /// The largest mark over 2^level x 2^level cells from this one on; 0 outside.
    [[nodiscard]] int mark(int level, int x, int y) const { return at(marks_, level, x, y); }
    /// Whether a scan of the map saw through any of these cells.
    [[nodiscard]] bool isSeen(int level, int x, int y) const { return at(seen_, level, x, y) != 0; }

    /// One point for each cell that has some, the mean of them: seen from the box's middle.
    void collect(const Box& box_map, Points& points) const;

 private:
    using Levels = std::array<std::vector<std::uint8_t>, kLevels>;

    [[nodiscard]] int cellOf(double from_edge_m) const;
    [[nodiscard]] int at(const Levels& levels, int level, int x, int y) const
    {
        // A block that begins before the raster may still reach into it.
        const int reach = 1 << level;
        if (x < 0 && x > -reach) x = 0;
        if (y < 0 && y > -reach) y = 0;
        if (x < 0 || y < 0 || x >= width_ || y >= height_) return 0;
        return levels[static_cast<std::size_t>(level)][index(x, y)];
    }
    [[nodiscard]] std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    void layOut(const PointsView& points_map);
    void markPoints(const PointsView& points_map);
    void markNear();
    void markSeen(const PointsView& points_map, const ScanTable& scans);
    void markRay(double from_x, double from_y, double to_x, double to_y);

    struct Mean
    {
        float x = 0, y = 0, count = 0;
    };
    static constexpr std::uint32_t kNoMean = ~std::uint32_t{0};

    int width_ = 0, height_ = 0;
    double min_x_ = 0, min_y_ = 0, cell_m_ = kFinestCell_m;
    Levels marks_, seen_;
    std::vector<std::uint32_t> mean_of_cell_;
    std::vector<Mean> means_;  ///< of the cells with points, from the raster's corner
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/wide_search.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace rtob
{
namespace
{
constexpr int kHit = 4, kNear = 2;  // a point on a reference cell, and on a cell beside one
}

/// Level 0 marks the reference's cells; level h holds the maximum over 2^h x 2^h cells from each.
void WideSearch::drawRaster(const PointsView& reference, double margin_m)
{
    const auto [low_x, high_x] = std::minmax_element(reference.x, reference.x + reference.size);
    const auto [low_y, high_y] = std::minmax_element(reference.y, reference.y + reference.size);
    min_x_ = *low_x - margin_m;
    min_y_ = *low_y - margin_m;
    width_ = static_cast<int>((*high_x + margin_m - min_x_) / kCell_m) + 1;
    height_ = static_cast<int>((*high_y + margin_m - min_y_) / kCell_m) + 1;
    const auto cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    levels_.resize(kLevels);
    for (auto& level : levels_)
    {
        if (level.capacity() < cells) level.reserve(2 * cells);  // so that it grows seldom
        level.assign(cells, 0);
    }

    auto& fine = levels_[0];
    for (std::size_t i = 0; i < reference.size; ++i)
    {
        const int cx = static_cast<int>((reference.x[i] - min_x_) / kCell_m);
        const int cy = static_cast<int>((reference.y[i] - min_y_) / kCell_m);
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
            {
                const int x = cx + dx, y = cy + dy;
                if (x < 0 || y < 0 || x >= width_ || y >= height_) continue;
                auto& cell = fine[static_cast<std::size_t>(y * width_ + x)];
                cell = std::max<std::uint8_t>(
                    cell, static_cast<std::uint8_t>(dx == 0 && dy == 0 ? kHit : kNear));
            }
    }
    for (int h = 1; h < kLevels; ++h)
    {
        const int step = 1 << (h - 1);
        const auto& below = levels_[static_cast<std::size_t>(h - 1)];
        auto& level = levels_[static_cast<std::size_t>(h)];
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x)
            {
                const int x2 = std::min(x + step, width_ - 1), y2 = std::min(y + step, height_ - 1);
                const auto at = [&](int u, int v)
                { return below[static_cast<std::size_t>(v * width_ + u)]; };
                level[static_cast<std::size_t>(y * width_ + x)] =
                    std::max({at(x, y), at(x2, y), at(x, y2), at(x2, y2)});
            }
    }
}

int WideSearch::scoreOf(int level, int shift_x, int shift_y) const
{
    const auto& raster = levels_[static_cast<std::size_t>(level)];
    const int reach = 1 << level;
    int score = 0;
    for (const CellOf& cell : cells_)
    {
        int x = cell.x + shift_x, y = cell.y + shift_y;
        // A block that begins before the raster may still reach into it.
        if (x < 0 && x > -reach) x = 0;
        if (y < 0 && y > -reach) y = 0;
        if (x < 0 || y < 0 || x >= width_ || y >= height_) continue;
        score += raster[static_cast<std::size_t>(y * width_ + x)];
    }
    return score;
}

void WideSearch::branch(int level, const Shift& parent, Shift& best)
{
    if (parent.score <= best.score) return;
    if (level == 0)
    {
        best = parent;
        return;
    }
    const int step = 1 << (level - 1);
    std::array<Shift, 4> children{};
    std::size_t n = 0;
    for (int dy = 0; dy <= step; dy += step)
        for (int dx = 0; dx <= step; dx += step)
        {
            const int x = parent.x + dx, y = parent.y + dy;
            if (x > half_cells_ || y > half_cells_) continue;
            // Kept in order, best first, so that the first branch sets a high mark.
            const Shift child{x, y, scoreOf(level - 1, x, y)};
            std::size_t place = n++;
            for (; place > 0 && children[place - 1].score < child.score; --place)
                children[place] = children[place - 1];
            children[place] = child;
        }
    for (std::size_t i = 0; i < n; ++i) branch(level - 1, children[i], best);
}

SearchResult WideSearch::search(
    const PointsView& points, const PointsView& reference, const SearchWindow& window)
{
    SearchResult result;
    if (points.size == 0 || reference.size == 0) return result;
    drawRaster(reference, window.half_width_m + kCell_m);
    half_cells_ = static_cast<int>(std::ceil(window.half_width_m / kCell_m));

    double range2 = 1.0;
    for (std::size_t i = 0; i < points.size; ++i)
        range2 = std::max<double>(range2, points.x[i] * points.x[i] + points.y[i] * points.y[i]);
    // One cell at the median range is enough: the far points tolerate the rest.
    const double yaw_step_rad = kCell_m / std::min(10.0, std::sqrt(range2));
    const int yaw_steps = static_cast<int>(std::ceil(window.half_angle_rad / yaw_step_rad));

    int best_score = 0;
    for (int k = 0; k <= 2 * yaw_steps; ++k)
    {
        const int yaw_index = (k % 2 == 0 ? 1 : -1) * ((k + 1) / 2);  // 0, -1, 1, -2, 2 ...
        const double yaw = yaw_step_rad * yaw_index, c = std::cos(yaw), s = std::sin(yaw);
        cells_.resize(points.size);
        for (std::size_t i = 0; i < points.size; ++i)
            cells_[i] = {
                static_cast<int>(
                    std::floor((c * points.x[i] - s * points.y[i] - min_x_) / kCell_m)),
                static_cast<int>(
                    std::floor((s * points.x[i] + c * points.y[i] - min_y_) / kCell_m))};
        Shift best{0, 0, best_score};
        constexpr int kTop = kLevels - 1;
        for (int y = -half_cells_; y <= half_cells_; y += 1 << kTop)
            for (int x = -half_cells_; x <= half_cells_; x += 1 << kTop)
                branch(kTop, {x, y, scoreOf(kTop, x, y)}, best);
        if (best.score > best_score)
        {
            best_score = best.score;
            result.correction = {best.x * kCell_m, best.y * kCell_m, yaw};
        }
    }
    result.score = static_cast<double>(best_score) / static_cast<double>(kHit) /
                   static_cast<double>(points.size);
    return result;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/wide_search.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "raster_pyramid.h"

namespace rtob
{
namespace
{
constexpr int kHit = 4, kNear = 2;  // a point on a reference cell, and on a cell beside one
constexpr double kCell_m = 0.1;

double range_of(const PointsView& points)
{
    double range2 = 1.0;
    for (std::size_t i = 0; i < points.size; ++i)
        range2 = std::max<double>(range2, points.x[i] * points.x[i] + points.y[i] * points.y[i]);
    return std::sqrt(range2);
}

Box box_of(const PointsView& points)
{
    const auto [low_x, high_x] = std::minmax_element(points.x, points.x + points.size);
    const auto [low_y, high_y] = std::minmax_element(points.y, points.y + points.size);
    return {*low_x, *low_y, *high_x, *high_y};
}

/// Where the turned and shifted points can come to lie on the reference, and a cell more.
Box reachable(
    const PointsView& points, const PointsView& reference, double range_m,
    const SearchWindow& window)
{
    const double turned_m = range_m * std::min(2.0, window.half_angle_rad);
    const double shifted_m = window.half_width_m + kCell_m;
    return box_of(points).grown(turned_m).common(box_of(reference)).grown(shifted_m);
}
}  // namespace

/// Level 0 marks the reference's cells; what lies outside cannot be reached.
void WideSearch::drawRaster(const PointsView& reference, const Box& within)
{
    min_x_ = within.min_x;
    min_y_ = within.min_y;
    width_ = static_cast<int>((within.max_x - min_x_) / kCell_m) + 1;
    height_ = static_cast<int>((within.max_y - min_y_) / kCell_m) + 1;
    const auto cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    levels_.resize(kLevels);
    for (auto& level : levels_)
    {
        if (level.capacity() < cells) level.reserve(2 * cells);  // so that it grows seldom
        level.resize(cells);
    }

    auto& fine = levels_[0];
    std::fill(fine.begin(), fine.end(), std::uint8_t{0});
    for (std::size_t i = 0; i < reference.size; ++i)
    {
        if (!within.contains(reference.x[i], reference.y[i])) continue;
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
    draw_pyramid(levels_.data(), levels_.size(), width_, height_);
}

/// @param mark once the score cannot exceed it any more, whatever it can still reach is returned.
int WideSearch::scoreOf(int level, int shift_x, int shift_y, int mark) const
{
    constexpr std::size_t kBetweenLooks = 32;
    const auto& raster = levels_[static_cast<std::size_t>(level)];
    const int reach = 1 << level;
    int score = 0;
    for (std::size_t begin = 0; begin < cells_.size(); begin += kBetweenLooks)
    {
        const int at_most = score + kHit * static_cast<int>(cells_.size() - begin);
        if (at_most <= mark) return at_most;
        const std::size_t end = std::min(begin + kBetweenLooks, cells_.size());
        for (std::size_t i = begin; i < end; ++i)
        {
            int x = cells_[i].x + shift_x, y = cells_[i].y + shift_y;
            // A block that begins before the raster may still reach into it.
            if (x < 0 && x > -reach) x = 0;
            if (y < 0 && y > -reach) y = 0;
            if (x < 0 || y < 0 || x >= width_ || y >= height_) continue;
            score += raster[static_cast<std::size_t>(y * width_ + x)];
        }
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
            const Shift child{x, y, scoreOf(level - 1, x, y, best.score)};
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
    const double range_m = range_of(points);
    const Box within = reachable(points, reference, range_m, window);
    if (within.min_x > within.max_x || within.min_y > within.max_y) return result;
    drawRaster(reference, within);
    half_cells_ = static_cast<int>(std::ceil(window.half_width_m / kCell_m));
    // One cell at the median range is enough: the far points tolerate the rest.
    const double yaw_step_rad = kCell_m / std::min(10.0, range_m);
    const int yaw_steps = static_cast<int>(std::ceil(window.half_angle_rad / yaw_step_rad));

    const double most = kHit * static_cast<double>(points.size);
    int best_score = std::max(0, static_cast<int>(std::ceil(window.min_score * most)) - 1);
    bool is_found = false;
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
                branch(kTop, {x, y, scoreOf(kTop, x, y, best.score)}, best);
        if (best.score > best_score)
        {
            best_score = best.score;
            is_found = true;
            result.correction = {best.x * kCell_m, best.y * kCell_m, yaw};
        }
    }
    if (is_found) result.score = best_score / most;
    return result;
}
}  // namespace rtob

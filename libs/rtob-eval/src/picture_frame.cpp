// SPDX-License-Identifier: BSD-3-Clause
#include "picture_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtob
{
namespace
{
constexpr int header_px = 92;      // title and facts
constexpr int footer_px = 72;      // scale bar and legend
constexpr int side_px = 40;        // free border left and right
constexpr int min_width_px = 900;  // header and footer need this much
constexpr int min_map_height_px = 160;
constexpr double max_px_per_m = 150;  // a small room does not fill a wall

struct Interval
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] bool isEmpty() const { return low > high; }
};

/// From the smallest to the largest value, strays left out: those that lie farther outside the
/// middle 99.8 % of the values than a tenth of its width.
Interval without_strays(std::vector<float>& values)
{
    if (values.empty()) return {};
    const auto at = [&](double share)
    {
        const auto rank =
            static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
        std::nth_element(values.begin(), values.begin() + rank, values.end());
        return static_cast<double>(values[static_cast<std::size_t>(rank)]);
    };
    const double low = at(0.001), high = at(0.999);
    const double allowance = 0.1 * (high - low);
    Interval interval;
    for (const double value : values)
        if (value >= low - allowance && value <= high + allowance) interval.include(value);
    return interval;
}

void make_at_least(double size, Interval& interval)
{
    if (interval.isEmpty()) interval.include(0);
    const double lacking = std::max(0.0, size - (interval.high - interval.low));
    interval.low -= lacking / 2;
    interval.high += lacking / 2;
}
}  // namespace

Box visible_box(const PointsView& points_map, const std::vector<Pose2>& path)
{
    std::vector<float> xs, ys;
    xs.reserve(points_map.size);
    ys.reserve(points_map.size);
    for (std::size_t i = 0; i < points_map.size; ++i)
    {
        if (!is_drawable(points_map.x[i], points_map.y[i])) continue;
        xs.push_back(points_map.x[i]);
        ys.push_back(points_map.y[i]);
    }
    Interval x = without_strays(xs), y = without_strays(ys);
    for (const auto& pose : path)
    {
        if (!is_drawable(pose)) continue;
        x.include(pose.x);
        y.include(pose.y);
    }
    make_at_least(1, x);
    make_at_least(1, y);
    return {x.low, y.low, x.high, y.high};
}

PictureFrame fitted_frame(const Box& visible_map, int max_long_side_px)
{
    const double longer_m =
        std::max(visible_map.max_x - visible_map.min_x, visible_map.max_y - visible_map.min_y);
    PictureFrame frame;
    frame.box_map = visible_map.grown(0.03 * longer_m);
    const double width_m = frame.box_map.max_x - frame.box_map.min_x;
    const double height_m = frame.box_map.max_y - frame.box_map.min_y;
    frame.px_per_m = std::min(
        {max_px_per_m, (max_long_side_px - 2 * side_px) / width_m,
         (max_long_side_px - header_px - footer_px) / height_m});
    const auto in_px = [&](double metres)
    { return static_cast<int>(std::floor(metres * frame.px_per_m)); };
    const int smallest_width_px = std::min(min_width_px, max_long_side_px);
    frame.map_px.width = std::max(smallest_width_px - 2 * side_px, in_px(width_m));
    frame.map_px.height = std::max(min_map_height_px, in_px(height_m));
    frame.map_px.x = side_px;
    frame.map_px.y = header_px;
    frame.picture_px = {
        frame.map_px.width + 2 * side_px, frame.map_px.height + header_px + footer_px};
    // Where the map is smaller than its part of the picture, it stands in the middle of it.
    const double free_x_m = frame.map_px.width / frame.px_per_m - width_m;
    const double free_y_m = frame.map_px.height / frame.px_per_m - height_m;
    frame.box_map.min_x -= free_x_m / 2;
    frame.box_map.max_x += free_x_m / 2;
    frame.box_map.min_y -= free_y_m / 2;
    frame.box_map.max_y += free_y_m / 2;
    return frame;
}
}  // namespace rtob

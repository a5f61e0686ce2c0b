// SPDX-License-Identifier: BSD-3-Clause
#include "picture_layers.h"

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr double text_height = 12;
const cv::Scalar start_bgr(94, 163, 22), end_bgr(38, 38, 220), ring_bgr(255, 255, 255);

/// Time along the path: blue, violet, pink, orange; all readable on white and beside the green and
/// red of start and end.
const ColourRamp time_ramp{{{235, 130, 20}, {235, 70, 110}, {170, 50, 215}, {30, 130, 250}}};

std::string length_text(double length_m)
{
    return length_m < 1 ? std::to_string(std::lround(100 * length_m)) + " cm"
                        : std::to_string(std::lround(length_m)) + " m";
}

double bar_length_m(const PictureFrame& frame)
{
    return round_down(220 / frame.px_per_m);
}

void arrowhead(Canvas& canvas, cv::Point2d at, double yaw, double size_px, const cv::Scalar& bgr)
{
    const cv::Point2d ahead(std::cos(yaw), -std::sin(yaw)), aside(ahead.y, -ahead.x);
    draw_polygon(
        canvas,
        {at + size_px * ahead, at - 0.8 * size_px * ahead + 0.75 * size_px * aside,
         at - 0.8 * size_px * ahead - 0.75 * size_px * aside},
        bgr);
}

void start_mark(Canvas& canvas, cv::Point2d at)
{
    draw_disc(canvas, at, 10, ring_bgr);
    draw_disc(canvas, at, 8, start_bgr);
}

void end_mark(Canvas& canvas, cv::Point2d at, double yaw)
{
    arrowhead(canvas, at, yaw, 15, ring_bgr);
    arrowhead(canvas, at, yaw, 11, end_bgr);
}
}  // namespace

void draw_ground(Canvas& canvas)
{
    const auto& box = canvas.frame.box_map;
    draw_card(canvas, canvas.frame.map_px);
    const double step_m = bar_length_m(canvas.frame);
    for (double x = std::ceil(box.min_x / step_m) * step_m; x <= box.max_x; x += step_m)
        draw_line(
            canvas, canvas.frame.pixel(x, box.min_y), canvas.frame.pixel(x, box.max_y), grid_bgr,
            1);
    for (double y = std::ceil(box.min_y / step_m) * step_m; y <= box.max_y; y += step_m)
        draw_line(
            canvas, canvas.frame.pixel(box.min_x, y), canvas.frame.pixel(box.max_x, y), grid_bgr,
            1);
}

void draw_path(Canvas& canvas, const std::vector<Pose2>& path)
{
    // A vehicle that creeps gives many poses a pixel: only steps that can be seen are drawn.
    constexpr double least_step_px = 0.75;
    bool has_last = false;
    cv::Point2d last;
    for (std::size_t i = 0; i < path.size(); ++i)
    {
        if (!is_drawable(path[i])) continue;
        const auto pixel = canvas.frame.pixel(path[i].x, path[i].y);
        if (has_last && cv::norm(pixel - last) < least_step_px && i + 1 < path.size()) continue;
        const double share = static_cast<double>(i) / static_cast<double>(path.size());
        if (has_last) draw_line(canvas, last, pixel, ramp_colour(time_ramp, share), 2);
        last = pixel;
        has_last = true;
    }
}

void draw_start_and_end(Canvas& canvas, const std::vector<Pose2>& path)
{
    const auto drawable = [](const Pose2& pose) { return is_drawable(pose); };
    const auto first = std::find_if(path.begin(), path.end(), drawable);
    if (first == path.end()) return;
    const auto last = std::find_if(path.rbegin(), path.rend(), drawable);
    start_mark(canvas, canvas.frame.pixel(first->x, first->y));
    end_mark(canvas, canvas.frame.pixel(last->x, last->y), last->yaw);
}

double footer_middle(const Canvas& canvas)
{
    return canvas.frame.map_px.br().y + 36;
}

void draw_scale_bar(Canvas& canvas)
{
    const double left = canvas.frame.map_px.x, middle = footer_middle(canvas);
    const double bar_m = bar_length_m(canvas.frame), bar_px = bar_m * canvas.frame.px_per_m;
    draw_line(canvas, {left, middle}, {left + bar_px, middle}, title_bgr, 2);
    for (const double end : {left, left + bar_px})
        draw_line(canvas, {end, middle - 7}, {end, middle + 7}, title_bgr, 2);
    draw_text(
        canvas, length_text(bar_m), {left + bar_px + 14, middle + text_height / 2}, text_height,
        title_bgr, 1);
}

void draw_mark_names(Canvas& canvas, double right)
{
    const double middle = footer_middle(canvas), bottom = middle + text_height / 2, gap = 14;
    const double end_at = right - text_width("end", text_height);
    draw_text(canvas, "end", {end_at, bottom}, text_height, title_bgr, 1);
    end_mark(canvas, {end_at - gap - 6, middle}, 0);
    const double start_at = end_at - 3 * gap - 20 - text_width("start", text_height);
    draw_text(canvas, "start", {start_at, bottom}, text_height, title_bgr, 1);
    start_mark(canvas, {start_at - gap - 4, middle});
}

void draw_time_legend(Canvas& canvas)
{
    const double right = canvas.frame.map_px.br().x, middle = footer_middle(canvas);
    const double bottom = middle + text_height / 2;
    const double gradient_px = 120, gap = 14;
    const double end_at = right - text_width("end", text_height);
    draw_text(canvas, "end", {end_at, bottom}, text_height, title_bgr, 1);
    end_mark(canvas, {end_at - gap - 6, middle}, 0);
    const double gradient_at = end_at - 2 * gap - 18 - gradient_px;
    draw_ramp(canvas, time_ramp, {gradient_at, middle}, gradient_px);
    start_mark(canvas, {gradient_at - gap - 6, middle});
    const double start_at = gradient_at - 2 * gap - 8 - text_width("start", text_height);
    draw_text(canvas, "start", {start_at, bottom}, text_height, title_bgr, 1);
}
}  // namespace rtob

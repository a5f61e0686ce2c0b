// SPDX-License-Identifier: BSD-3-Clause
#include "picture_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace rtob
{
namespace
{
constexpr int shift_bits = 4;  // OpenCV draws to 1/16 of a pixel
const cv::Scalar card_bgr(255, 255, 255), border_bgr(222, 216, 209), grid_bgr(243, 239, 235);
const cv::Scalar title_bgr(55, 41, 31), facts_bgr(128, 114, 107);
const cv::Scalar start_bgr(94, 163, 22), end_bgr(38, 38, 220), ring_bgr(255, 255, 255);

/// A point of the picture on the canvas, in OpenCV's fixed point.
cv::Point fixed(const Canvas& canvas, cv::Point2d picture_px)
{
    // The centre of OpenCV's pixel i is at i, of ours at i + 0.5.
    const double scale = 1 << shift_bits;
    return {
        cvRound((picture_px.x * canvas.zoom - 0.5) * scale),
        cvRound((picture_px.y * canvas.zoom - 0.5) * scale)};
}

void line(Canvas& canvas, cv::Point2d a, cv::Point2d b, const cv::Scalar& bgr, double width_px)
{
    const int thickness = std::max(1, cvRound(width_px * canvas.zoom));
    cv::line(
        canvas.image, fixed(canvas, a), fixed(canvas, b), bgr, thickness, cv::LINE_AA, shift_bits);
}

void disc(Canvas& canvas, cv::Point2d centre, double radius_px, const cv::Scalar& bgr)
{
    cv::circle(
        canvas.image, fixed(canvas, centre), cvRound(radius_px * canvas.zoom * (1 << shift_bits)),
        bgr, cv::FILLED, cv::LINE_AA, shift_bits);
}

void polygon(Canvas& canvas, const std::vector<cv::Point2d>& corners, const cv::Scalar& bgr)
{
    std::vector<cv::Point> points;
    for (const auto& corner : corners) points.push_back(fixed(canvas, corner));
    cv::fillConvexPoly(canvas.image, points, bgr, cv::LINE_AA, shift_bits);
}

constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
constexpr double font_height_px = 22;  // of a capital letter at font scale 1

/// Width of a text whose capitals are `height_px` high, in pixels of the picture.
double text_width(const std::string& text, double height_px)
{
    int baseline = 0;
    return cv::getTextSize(text, font, 1, 1, &baseline).width * height_px / font_height_px;
}

void write(
    Canvas& canvas, const std::string& text, cv::Point2d left_bottom, double height_px,
    const cv::Scalar& bgr, double stroke_px)
{
    cv::putText(
        canvas.image, text,
        {cvRound(left_bottom.x * canvas.zoom), cvRound(left_bottom.y * canvas.zoom)}, font,
        canvas.zoom * height_px / font_height_px, bgr,
        std::max(1, cvRound(stroke_px * canvas.zoom)), cv::LINE_AA);
}

/// Time along the path, 0 to 1, as a colour: blue, violet, pink, orange; all readable on white and
/// beside the green and red of start and end.
cv::Scalar time_colour(double share)
{
    static const std::array<cv::Scalar, 4> stops{
        {{235, 130, 20}, {235, 70, 110}, {170, 50, 215}, {30, 130, 250}}};
    const double position = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
    const auto before = std::min(static_cast<std::size_t>(position), stops.size() - 2);
    const double part = position - static_cast<double>(before);
    return stops[before] * (1 - part) + stops[before + 1] * part;
}

/// 1, 2 or 5 times a power of ten: the largest that is no longer than `longest_m`.
double round_length_m(double longest_m)
{
    const double power = std::pow(10, std::floor(std::log10(longest_m)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= longest_m) return factor * power;
    return power;
}

std::string length_text(double length_m)
{
    return length_m < 1 ? std::to_string(std::lround(100 * length_m)) + " cm"
                        : std::to_string(std::lround(length_m)) + " m";
}

double bar_length_m(const PictureFrame& frame)
{
    return round_length_m(220 / frame.px_per_m);
}

void arrowhead(Canvas& canvas, cv::Point2d at, double yaw, double size_px, const cv::Scalar& bgr)
{
    const cv::Point2d ahead(std::cos(yaw), -std::sin(yaw)), aside(ahead.y, -ahead.x);
    polygon(
        canvas,
        {at + size_px * ahead, at - 0.8 * size_px * ahead + 0.75 * size_px * aside,
         at - 0.8 * size_px * ahead - 0.75 * size_px * aside},
        bgr);
}

void start_mark(Canvas& canvas, cv::Point2d at)
{
    disc(canvas, at, 10, ring_bgr);
    disc(canvas, at, 8, start_bgr);
}

void end_mark(Canvas& canvas, cv::Point2d at, double yaw)
{
    arrowhead(canvas, at, yaw, 15, ring_bgr);
    arrowhead(canvas, at, yaw, 11, end_bgr);
}
}  // namespace

void draw_ground(Canvas& canvas)
{
    const auto& map = canvas.frame.map_px;
    const auto& box = canvas.frame.box_map;
    const int zoom = canvas.zoom;
    cv::rectangle(
        canvas.image, {map.x * zoom, map.y * zoom, map.width * zoom, map.height * zoom}, card_bgr,
        cv::FILLED);
    const double step_m = bar_length_m(canvas.frame);
    for (double x = std::ceil(box.min_x / step_m) * step_m; x <= box.max_x; x += step_m)
        line(
            canvas, canvas.frame.pixel(x, box.min_y), canvas.frame.pixel(x, box.max_y), grid_bgr,
            1);
    for (double y = std::ceil(box.min_y / step_m) * step_m; y <= box.max_y; y += step_m)
        line(
            canvas, canvas.frame.pixel(box.min_x, y), canvas.frame.pixel(box.max_x, y), grid_bgr,
            1);
    const cv::Point2d corner(map.x, map.y), opposite(map.x + map.width, map.y + map.height);
    line(canvas, corner, {opposite.x, corner.y}, border_bgr, 1);
    line(canvas, {opposite.x, corner.y}, opposite, border_bgr, 1);
    line(canvas, opposite, {corner.x, opposite.y}, border_bgr, 1);
    line(canvas, {corner.x, opposite.y}, corner, border_bgr, 1);
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
        if (has_last) line(canvas, last, pixel, time_colour(share), 2);
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

void draw_header(Canvas& canvas, const std::string& title, const std::string& facts)
{
    const double left = canvas.frame.map_px.x, width = canvas.frame.map_px.width;
    const auto fitting = [&](const std::string& text, double height_px)
    { return height_px * std::min(1.0, width / std::max(1.0, text_width(text, height_px))); };
    write(canvas, title, {left, 42}, fitting(title, 19), title_bgr, 1.5);
    write(canvas, facts, {left, 74}, fitting(facts, 12), facts_bgr, 1);
}

void draw_footer(Canvas& canvas, bool has_path)
{
    const auto& map = canvas.frame.map_px;
    const double left = map.x, right = map.x + map.width, middle = map.y + map.height + 36;
    const double text_height = 12, bottom = middle + text_height / 2;

    const double bar_m = bar_length_m(canvas.frame), bar_px = bar_m * canvas.frame.px_per_m;
    line(canvas, {left, middle}, {left + bar_px, middle}, title_bgr, 2);
    for (const double end : {left, left + bar_px})
        line(canvas, {end, middle - 7}, {end, middle + 7}, title_bgr, 2);
    write(canvas, length_text(bar_m), {left + bar_px + 14, bottom}, text_height, title_bgr, 1);
    if (!has_path) return;

    const double gradient_px = 120, gap = 14;
    const double end_at = right - text_width("end", text_height);
    write(canvas, "end", {end_at, bottom}, text_height, title_bgr, 1);
    end_mark(canvas, {end_at - gap - 6, middle}, 0);
    const double gradient_end = end_at - 2 * gap - 18, gradient_at = gradient_end - gradient_px;
    for (int i = 0; i < 60; ++i)
        line(
            canvas, {gradient_at + gradient_px * i / 60, middle},
            {gradient_at + gradient_px * (i + 1) / 60, middle}, time_colour(i / 59.0), 4);
    start_mark(canvas, {gradient_at - gap - 6, middle});
    const double start_at = gradient_at - 2 * gap - 8 - text_width("start", text_height);
    write(canvas, "start", {start_at, bottom}, text_height, title_bgr, 1);
}
}  // namespace rtob

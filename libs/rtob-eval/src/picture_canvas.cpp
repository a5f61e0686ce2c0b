// SPDX-License-Identifier: BSD-3-Clause
#include "picture_canvas.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace rtob
{
namespace
{
constexpr int shift_bits = 4;  // OpenCV draws to 1/16 of a pixel
constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
constexpr double font_height_px = 22;  // of a capital letter at font scale 1

/// A point of the picture on the canvas, in OpenCV's fixed point.
cv::Point fixed(const Canvas& canvas, cv::Point2d picture_px)
{
    // The centre of OpenCV's pixel i is at i, of ours at i + 0.5.
    const double scale = 1 << shift_bits;
    return {
        cvRound((picture_px.x * canvas.zoom - 0.5) * scale),
        cvRound((picture_px.y * canvas.zoom - 0.5) * scale)};
}
}  // namespace

Canvas blank_canvas(const PictureFrame& frame, int zoom)
{
    return {cv::Mat(frame.picture_px * zoom, CV_8UC3, page_bgr), zoom, frame};
}

cv::Mat finished_picture(const Canvas& canvas)
{
    cv::Mat picture;
    cv::resize(canvas.image, picture, canvas.frame.picture_px, 0, 0, cv::INTER_AREA);
    return picture;
}

void draw_line(Canvas& canvas, cv::Point2d a, cv::Point2d b, const cv::Scalar& bgr, double width)
{
    const int thickness = std::max(1, cvRound(width * canvas.zoom));
    cv::line(
        canvas.image, fixed(canvas, a), fixed(canvas, b), bgr, thickness, cv::LINE_AA, shift_bits);
}

void draw_disc(Canvas& canvas, cv::Point2d centre, double radius, const cv::Scalar& bgr)
{
    cv::circle(
        canvas.image, fixed(canvas, centre), cvRound(radius * canvas.zoom * (1 << shift_bits)), bgr,
        cv::FILLED, cv::LINE_AA, shift_bits);
}

void draw_polygon(Canvas& canvas, const std::vector<cv::Point2d>& corners, const cv::Scalar& bgr)
{
    std::vector<cv::Point> points;
    for (const auto& corner : corners) points.push_back(fixed(canvas, corner));
    cv::fillConvexPoly(canvas.image, points, bgr, cv::LINE_AA, shift_bits);
}

void draw_card(Canvas& canvas, const cv::Rect& place)
{
    const int zoom = canvas.zoom;
    cv::rectangle(
        canvas.image, {place.x * zoom, place.y * zoom, place.width * zoom, place.height * zoom},
        card_bgr, cv::FILLED);
    const cv::Point2d corner = place.tl(), opposite = place.br();
    draw_line(canvas, corner, {opposite.x, corner.y}, border_bgr, 1);
    draw_line(canvas, {opposite.x, corner.y}, opposite, border_bgr, 1);
    draw_line(canvas, opposite, {corner.x, opposite.y}, border_bgr, 1);
    draw_line(canvas, {corner.x, opposite.y}, corner, border_bgr, 1);
}

void draw_text(
    Canvas& canvas, const std::string& text, cv::Point2d left_bottom, double height,
    const cv::Scalar& bgr, double stroke)
{
    cv::putText(
        canvas.image, text,
        {cvRound(left_bottom.x * canvas.zoom), cvRound(left_bottom.y * canvas.zoom)}, font,
        canvas.zoom * height / font_height_px, bgr, std::max(1, cvRound(stroke * canvas.zoom)),
        cv::LINE_AA);
}

double text_width(const std::string& text, double height)
{
    int baseline = 0;
    return cv::getTextSize(text, font, 1, 1, &baseline).width * height / font_height_px;
}

void draw_header(Canvas& canvas, const std::string& title, const std::string& facts)
{
    const double left = canvas.frame.map_px.x, width = canvas.frame.map_px.width;
    const auto fitting = [&](const std::string& text, double height)
    { return height * std::min(1.0, width / std::max(1.0, text_width(text, height))); };
    draw_text(canvas, title, {left, 42}, fitting(title, 19), title_bgr, 1.5);
    draw_text(canvas, facts, {left, 74}, fitting(facts, 12), facts_bgr, 1);
}

cv::Scalar ramp_colour(const ColourRamp& ramp, double share)
{
    const double position = std::clamp(share, 0.0, 1.0) * static_cast<double>(ramp.size() - 1);
    const auto before = std::min(static_cast<std::size_t>(position), ramp.size() - 2);
    const double part = position - static_cast<double>(before);
    return ramp[before] * (1 - part) + ramp[before + 1] * part;
}

void draw_ramp(Canvas& canvas, const ColourRamp& ramp, cv::Point2d left_middle, double width)
{
    constexpr int pieces = 60;
    for (int i = 0; i < pieces; ++i)
        draw_line(
            canvas, left_middle + cv::Point2d(width * i / pieces, 0),
            left_middle + cv::Point2d(width * (i + 1) / pieces, 0),
            ramp_colour(ramp, i / (pieces - 1.0)), 4);
}

double round_down(double limit)
{
    const double power = std::pow(10, std::floor(std::log10(limit)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= limit) return factor * power;
    return power;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/error_pictures.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "picture_canvas.h"
#include "png_file.h"

namespace rtob
{
namespace
{
constexpr int header_px = 128, panel_px = 300, below_panel_px = 100, left_px = 120, right_px = 150;
constexpr int panel_width_px = 1330;
constexpr double text_height = 12;
constexpr int tick_digits = 7;  // ticks are round: this is about long times
const cv::Scalar dot_bgr(225, 120, 40), mean_bgr(94, 163, 22), rmse_bgr(38, 38, 220);

std::string short_text(double number, int digits)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return text;
}

/// Where a panel's values lie on the picture.
struct Panel
{
    cv::Rect place_px;
    double end_x = 1, end_y = 1;  ///< both axes start at 0

    [[nodiscard]] cv::Point2d pixel(double x, double y) const
    {
        return {
            place_px.x + x / end_x * place_px.width, place_px.br().y - y / end_y * place_px.height};
    }
};

/// Round numbers from 0 to the end, about `wanted`; counted, as adding up a step would round.
std::vector<double> ticks(double end, int wanted)
{
    const double step = round_down(end / wanted);
    std::vector<double> values;
    for (int i = 0; i * step <= end; ++i) values.push_back(i * step);
    return values;
}

void draw_axes(Canvas& canvas, const Panel& panel, const ErrorCurve& curve)
{
    draw_card(canvas, panel.place_px);
    for (const double y : ticks(panel.end_y, 4))
    {
        if (y > 0) draw_line(canvas, panel.pixel(0, y), panel.pixel(panel.end_x, y), grid_bgr, 1);
        const auto text = short_text(y, tick_digits);
        const double left = panel.place_px.x - 12 - text_width(text, text_height);
        draw_text(
            canvas, text, {left, panel.pixel(0, y).y + text_height / 2}, text_height, facts_bgr, 1);
    }
    for (const double x : ticks(panel.end_x, 8))
    {
        if (x > 0) draw_line(canvas, panel.pixel(x, 0), panel.pixel(x, panel.end_y), grid_bgr, 1);
        const auto text = short_text(x, tick_digits);
        draw_text(
            canvas, text,
            {panel.pixel(x, 0).x - text_width(text, text_height) / 2,
             panel.place_px.br().y + 14 + text_height},
            text_height, facts_bgr, 1);
    }
    draw_text(
        canvas, curve.name, {panel.place_px.x + 0.0, panel.place_px.y - 12.0}, text_height + 1,
        title_bgr, 1);
    const std::string time_name = "time since the first, s";
    draw_text(
        canvas, time_name,
        {panel.place_px.br().x - text_width(time_name, text_height),
         panel.place_px.br().y + 36 + text_height},
        text_height, facts_bgr, 1);
}

void draw_level(
    Canvas& canvas, const Panel& panel, const std::string& name, double value, double text_y,
    const cv::Scalar& bgr)
{
    draw_line(canvas, panel.pixel(0, value), panel.pixel(panel.end_x, value), bgr, 1);
    draw_text(
        canvas, name + " " + short_text(value, 3), {panel.place_px.br().x + 12.0, text_y},
        text_height, bgr, 1);
}

/// Mean and RMSE, their names beside the panel; the RMSE is never below the mean.
void draw_levels(Canvas& canvas, const Panel& panel, const ErrorCurve& curve)
{
    constexpr double least_distance_px = 20;
    const double mean_y = panel.pixel(0, curve.mean).y + text_height / 2;
    const double rmse_y = panel.pixel(0, curve.rmse).y + text_height / 2;
    draw_level(
        canvas, panel, "rmse", curve.rmse, std::min(rmse_y, mean_y - least_distance_px), rmse_bgr);
    draw_level(canvas, panel, "mean", curve.mean, mean_y, mean_bgr);
}

void check(const ErrorPlotInput& input)
{
    if (input.times_s.empty() || input.curves.empty())
        throw std::invalid_argument("a plot of errors needs at least one");
    for (const auto& curve : input.curves)
        if (curve.values.size() != input.times_s.size())
            throw std::invalid_argument("a plot of errors needs a time for each");
}
}  // namespace

cv::Mat draw_error_plot(const ErrorPlotInput& input)
{
    check(input);
    const auto [first, last] = std::minmax_element(input.times_s.begin(), input.times_s.end());
    const auto above_zero = [](double value) { return value > 0 ? value : 1; };

    PictureFrame frame;
    const int panels = static_cast<int>(input.curves.size());
    frame.picture_px = {
        left_px + panel_width_px + right_px, header_px + panels * (panel_px + below_panel_px) - 34};
    frame.map_px = {left_px, header_px, panel_width_px, panel_px};
    Canvas canvas = blank_canvas(frame, 2);
    draw_header(canvas, input.title, input.facts);
    Panel panel{frame.map_px, above_zero(*last - *first), 1};
    for (const auto& curve : input.curves)
    {
        const double largest = *std::max_element(curve.values.begin(), curve.values.end());
        panel.end_y = above_zero(1.08 * largest);
        draw_axes(canvas, panel, curve);
        for (std::size_t i = 0; i < curve.values.size(); ++i)
            draw_disc(
                canvas, panel.pixel(input.times_s[i] - *first, curve.values[i]), 1.8, dot_bgr);
        draw_levels(canvas, panel, curve);
        panel.place_px.y += panel_px + below_panel_px;
    }
    return finished_picture(canvas);
}

void write_error_plot(const std::string& file, const ErrorPlotInput& input)
{
    write_png(file, draw_error_plot(input));
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/error_pictures.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <stdexcept>

#include "picture_layers.h"
#include "png_file.h"

namespace rtob
{
namespace
{
/// Small errors blue, large ones red; start and end are marked on top.
const ColourRamp error_ramp{{{235, 130, 20}, {150, 170, 20}, {20, 150, 245}, {30, 30, 210}}};
const cv::Scalar reference_bgr(190, 184, 178), unknown_bgr(205, 200, 196);

std::vector<double> known(const std::vector<double>& errors_m)
{
    std::vector<double> values;
    for (const double error_m : errors_m)
        if (!std::isnan(error_m)) values.push_back(error_m);
    return values;
}

struct ColourScale
{
    double end_m = 1;  ///< the last colour
    bool is_clipped = false;
};

ColourScale scale_of(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const double largest_m = values.back();
    const double most_m = values[(values.size() - 1) * 98 / 100];
    if (most_m > 0 && largest_m > 1.5 * most_m) return {most_m, true};
    return {largest_m > 0 ? largest_m : 1, false};
}

std::string metres_text(double metres)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g m", metres);
    return text;
}

void draw_plain_path(Canvas& canvas, const std::vector<Pose2>& path, const cv::Scalar& bgr)
{
    for (std::size_t i = 1; i < path.size(); ++i)
        if (is_drawable(path[i - 1]) && is_drawable(path[i]))
            draw_line(
                canvas, canvas.frame.pixel(path[i - 1].x, path[i - 1].y),
                canvas.frame.pixel(path[i].x, path[i].y), bgr, 1.5);
}

/// The way to each pose whose error is known from the one before, a dot where its neighbours' are
/// not known; the largest errors last, so that nothing hides them.
void draw_errors(Canvas& canvas, const ErrorPathInput& input, const ColourScale& scale)
{
    std::vector<std::size_t> order(input.path.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto is_shown = [&](std::size_t i)
    { return !std::isnan(input.errors_m[i]) && is_drawable(input.path[i]); };
    order.erase(
        std::remove_if(order.begin(), order.end(), [&](std::size_t i) { return !is_shown(i); }),
        order.end());
    std::stable_sort(
        order.begin(), order.end(),
        [&](std::size_t a, std::size_t b) { return input.errors_m[a] < input.errors_m[b]; });
    for (const std::size_t i : order)
    {
        const auto bgr = ramp_colour(error_ramp, input.errors_m[i] / scale.end_m);
        const auto here = canvas.frame.pixel(input.path[i].x, input.path[i].y);
        if (i > 0 && is_shown(i - 1))
            draw_line(
                canvas, canvas.frame.pixel(input.path[i - 1].x, input.path[i - 1].y), here, bgr, 3);
        const bool is_single =
            (i == 0 || !is_shown(i - 1)) && (i + 1 == input.path.size() || !is_shown(i + 1));
        if (is_single) draw_disc(canvas, here, 2.5, bgr);
    }
}

/// Below the map on the right: what marks, grey line and colours mean.
void draw_legend(Canvas& canvas, const ColourScale& scale, bool has_reference)
{
    constexpr double ramp_px = 160, gap = 12, height = 12;
    const double middle = footer_middle(canvas), bottom = middle + height / 2;
    double left = canvas.frame.map_px.br().x;
    const auto put_text = [&](const std::string& text)
    {
        left -= text_width(text, height);
        draw_text(canvas, text, {left, bottom}, height, title_bgr, 1);
        left -= gap;
    };
    put_text(metres_text(scale.end_m) + (scale.is_clipped ? " or more" : ""));
    left -= ramp_px;
    draw_ramp(canvas, error_ramp, {left, middle}, ramp_px);
    left -= gap;
    put_text("translation error  0");
    left -= 2 * gap;
    if (has_reference)
    {
        put_text("reference");
        draw_line(canvas, {left - 40, middle}, {left, middle}, reference_bgr, 3);
        left -= 40 + 3 * gap;
    }
    draw_mark_names(canvas, left);
}
}  // namespace

cv::Mat draw_error_path(const ErrorPathInput& input)
{
    if (input.max_long_side_px < 400)
        throw std::invalid_argument("a picture needs a long side of at least 400 px");
    const auto values = known(input.errors_m);
    if (values.empty() || input.errors_m.size() != input.path.size())
        throw std::invalid_argument("a picture of errors needs one for each pose");
    auto visible = input.path;
    visible.insert(visible.end(), input.reference.begin(), input.reference.end());
    const ColourScale scale = scale_of(values);

    Canvas canvas = blank_canvas(fitted_frame(visible_box({}, visible), input.max_long_side_px), 2);
    draw_ground(canvas);
    draw_plain_path(canvas, input.reference, reference_bgr);
    draw_plain_path(canvas, input.path, unknown_bgr);
    draw_errors(canvas, input, scale);
    draw_start_and_end(canvas, input.path);
    draw_header(canvas, input.title, input.facts);
    draw_scale_bar(canvas);
    draw_legend(canvas, scale, !input.reference.empty());
    return finished_picture(canvas);
}

void write_error_path(const std::string& file, const ErrorPathInput& input)
{
    write_png(file, draw_error_path(input));
}
}  // namespace rtob

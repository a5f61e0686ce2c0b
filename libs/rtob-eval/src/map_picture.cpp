// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/map_picture.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "picture_frame.h"
#include "picture_layers.h"
#include "png_file.h"
#include "point_shading.h"

namespace rtob
{
namespace
{
const cv::Scalar wall_bgr(66, 48, 34);

/// 1234567 as "1 234 567".
std::string grouped(std::size_t number)
{
    std::string text = std::to_string(number);
    for (auto i = static_cast<std::ptrdiff_t>(text.size()) - 3; i > 0; i -= 3)
        text.insert(static_cast<std::size_t>(i), " ");
    return text;
}

double length_m(const std::vector<Pose2>& path)
{
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
        if (is_drawable(path[i - 1]) && is_drawable(path[i]))
            length += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
    return length;
}

std::string facts_of(const MapPictureInput& input, const Box& visible_map)
{
    const auto rounded = [](double metres) { return std::to_string(std::lround(metres)); };
    return rounded(visible_map.max_x - visible_map.min_x) + " m x " +
           rounded(visible_map.max_y - visible_map.min_y) + " m,  " +
           grouped(input.points_map.size) + " points,  " + rounded(length_m(input.path)) +
           " m driven in " + grouped(input.path.size()) + " poses";
}
}  // namespace

cv::Mat draw_map(const MapPictureInput& input)
{
    if (input.max_long_side_px < 400)
        throw std::invalid_argument("a map picture needs a long side of at least 400 px");
    const Box visible_map = visible_box(input.points_map, input.path);
    const PictureFrame frame = fitted_frame(visible_map, input.max_long_side_px);

    Canvas canvas = blank_canvas(frame, 1);
    draw_ground(canvas);
    shade_points(canvas.image, input.points_map, frame, wall_bgr);
    // Walls keep the picture's own pixels, which makes them crisp; lines and letters are drawn
    // larger.
    canvas.zoom = 2;
    cv::resize(canvas.image, canvas.image, frame.picture_px * canvas.zoom, 0, 0, cv::INTER_NEAREST);
    draw_path(canvas, input.path);
    draw_start_and_end(canvas, input.path);
    draw_header(canvas, input.title, facts_of(input, visible_map));
    draw_scale_bar(canvas);
    if (!input.path.empty()) draw_time_legend(canvas);
    return finished_picture(canvas);
}

void write_map_picture(const std::string& file, const MapPictureInput& input)
{
    write_png(file, draw_map(input));
}
}  // namespace rtob

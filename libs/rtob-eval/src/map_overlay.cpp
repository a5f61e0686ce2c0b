// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/map_overlay.h>

#include <algorithm>
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
const cv::Scalar reference_bgr(225, 130, 30), estimate_bgr(60, 60, 230);

Box box_of_both(const MapOverlayInput& input)
{
    const Box a = visible_box(input.points_reference, {}),
              b = visible_box(input.points_estimate, {});
    return {
        std::min(a.min_x, b.min_x), std::min(a.min_y, b.min_y), std::max(a.max_x, b.max_x),
        std::max(a.max_y, b.max_y)};
}
}  // namespace

cv::Mat draw_map_overlay(const MapOverlayInput& input)
{
    if (input.max_long_side_px < 400)
        throw std::invalid_argument("a map picture needs a long side of at least 400 px");
    const PictureFrame frame = fitted_frame(box_of_both(input), input.max_long_side_px);
    Canvas canvas = blank_canvas(frame, 1);
    draw_ground(canvas);
    cv::Mat estimate = canvas.image.clone();
    shade_points(canvas.image, input.points_reference, frame, reference_bgr);
    shade_points(estimate, input.points_estimate, frame, estimate_bgr);
    // Like two inks on one paper: what both cover is darker than either.
    cv::min(canvas.image, estimate, canvas.image);
    canvas.zoom = 2;
    cv::resize(canvas.image, canvas.image, frame.picture_px * canvas.zoom, 0, 0, cv::INTER_NEAREST);
    draw_header(canvas, input.title, input.facts);
    draw_scale_bar(canvas);
    return finished_picture(canvas);
}

void write_map_overlay(const std::string& file, const MapOverlayInput& input)
{
    write_png(file, draw_map_overlay(input));
}
}  // namespace rtob

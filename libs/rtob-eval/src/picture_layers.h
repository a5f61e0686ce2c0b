// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "picture_frame.h"

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

/// The lines and letters of a map picture. Each is drawn on a canvas `zoom` times as large as the
/// picture, which is shrunk afterwards: that smooths OpenCV's letters and circles.
namespace rtob
{
struct Canvas
{
    cv::Mat image;  ///< 8-bit BGR
    int zoom = 2;
    PictureFrame frame;  ///< in pixels of the picture, not of the canvas
};

/// The card that the map lies on, with a faint grid of round metres.
void draw_ground(Canvas& canvas);
void draw_path(Canvas& canvas, const std::vector<Pose2>& path);
/// A disc at the start, an arrowhead along the vehicle's heading at the end.
void draw_start_and_end(Canvas& canvas, const std::vector<Pose2>& path);
void draw_header(Canvas& canvas, const std::string& title, const std::string& facts);
void draw_footer(Canvas& canvas, bool has_path);
}  // namespace rtob

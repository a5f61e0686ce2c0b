// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "picture_frame.h"

#include <array>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

/// Lines, letters and colours that all pictures share.
namespace rtob
{
/// Everything is drawn `zoom` times as large as the picture, which is shrunk afterwards: that
/// smooths OpenCV's letters and circles.
struct Canvas
{
    cv::Mat image;  ///< 8-bit BGR
    int zoom = 2;
    PictureFrame frame;  ///< in pixels of the picture, not of the canvas
};

inline const cv::Scalar page_bgr(251, 249, 247), card_bgr(255, 255, 255);
inline const cv::Scalar border_bgr(222, 216, 209), grid_bgr(243, 239, 235);
inline const cv::Scalar title_bgr(55, 41, 31), facts_bgr(128, 114, 107);

[[nodiscard]] Canvas blank_canvas(const PictureFrame& frame, int zoom);
/// The canvas's picture in its own size.
[[nodiscard]] cv::Mat finished_picture(const Canvas& canvas);

// All places and sizes are in pixels of the picture.
void draw_line(Canvas& canvas, cv::Point2d a, cv::Point2d b, const cv::Scalar& bgr, double width);
void draw_disc(Canvas& canvas, cv::Point2d centre, double radius, const cv::Scalar& bgr);
void draw_polygon(Canvas& canvas, const std::vector<cv::Point2d>& corners, const cv::Scalar& bgr);
/// A white card with a border.
void draw_card(Canvas& canvas, const cv::Rect& place);

/// ASCII only; `height` is that of a capital letter.
void draw_text(
    Canvas& canvas, const std::string& text, cv::Point2d left_bottom, double height,
    const cv::Scalar& bgr, double stroke);
[[nodiscard]] double text_width(const std::string& text, double height);
/// Title and facts above the card; long ones are written smaller.
void draw_header(Canvas& canvas, const std::string& title, const std::string& facts);

using ColourRamp = std::array<cv::Scalar, 4>;
/// The colour at a share of the ramp, 0 to 1.
[[nodiscard]] cv::Scalar ramp_colour(const ColourRamp& ramp, double share);
/// The ramp as a bar from `left_middle` to the right.
void draw_ramp(Canvas& canvas, const ColourRamp& ramp, cv::Point2d left_middle, double width);

/// 1, 2 or 5 times a power of ten: the largest that is not above `limit`.
[[nodiscard]] double round_down(double limit);
}  // namespace rtob

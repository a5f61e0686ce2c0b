// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "picture_frame.h"

#include <opencv2/core/mat.hpp>

namespace rtob
{
/// How dark each pixel of frame.map_px is: 0 no points, 1 many. 32-bit float.
[[nodiscard]] cv::Mat point_darkness(const PointsView& points_map, const PictureFrame& frame);

/// Mixes `ink_bgr` into the picture's map by that darkness.
void shade_points(
    cv::Mat& picture, const PointsView& points_map, const PictureFrame& frame,
    const cv::Scalar& ink_bgr);
}  // namespace rtob

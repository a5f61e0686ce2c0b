// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>

#include <opencv2/core/mat.hpp>
#include <string>

namespace rtob
{
struct MapOverlayInput
{
    PointsView points_reference;  ///< any number; points that are not finite are left out
    PointsView points_estimate;   ///< in the reference's map frame
    std::string title, facts;     ///< a line each, of ASCII
    int max_long_side_px = 1600;  ///< >= 400
};

/// Draws two maps of one place over each other, the reference in blue and the estimate in red:
/// where they agree the walls are dark violet, where they do not two colours lie side by side.
/// 8-bit BGR.
[[nodiscard]] cv::Mat draw_map_overlay(const MapOverlayInput& input);

/// Writes it as a PNG, as write_map_picture() does.
void write_map_overlay(const std::string& file, const MapOverlayInput& input);
}  // namespace rtob

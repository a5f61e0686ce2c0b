// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace rtob
{
struct MapPictureInput
{
    PointsView points_map;        ///< any number; points that are not finite are left out
    std::vector<Pose2> path;      ///< map <- vehicle, in the order driven
    std::string title;            ///< one line of ASCII
    int max_long_side_px = 1600;  ///< >= 400
};

/// Draws a map as people look at it: dark walls (the more points, the darker), the path coloured by
/// time, its start and end, a scale bar. The whole path is visible, and all of the map except far
/// stray points. 8-bit BGR.
[[nodiscard]] cv::Mat draw_map(const MapPictureInput& input);

/// Writes draw_map's picture as a PNG; a file of that name holds either its old or the whole new
/// content. Throws std::runtime_error when it cannot be written.
void write_map_picture(const std::string& file, const MapPictureInput& input);
}  // namespace rtob

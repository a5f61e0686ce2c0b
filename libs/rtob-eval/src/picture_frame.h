// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/eval/map_picture.h>

#include <cmath>
#include <opencv2/core/types.hpp>

namespace rtob
{
/// Where things are on the picture, and how metres of the map become pixels.
struct PictureFrame
{
    cv::Size picture_px;
    cv::Rect map_px;  ///< the part of the picture that shows the map
    Box box_map;      ///< what map_px shows, m
    double px_per_m = 1;

    /// Pixel i covers [i, i + 1): its centre is at i + 0.5.
    [[nodiscard]] cv::Point2d pixel(double x, double y) const
    {
        return {
            map_px.x + (x - box_map.min_x) * px_per_m, map_px.y + (box_map.max_y - y) * px_per_m};
    }
};

/// Not NaN, and nearer than a quarter of the Earth: beyond that a trajectory has gone astray, and
/// pixels overflow.
[[nodiscard]] inline bool is_drawable(double x, double y)
{
    constexpr double far_m = 1e7;
    return std::abs(x) < far_m && std::abs(y) < far_m;
}
[[nodiscard]] inline bool is_drawable(const Pose2& pose)
{
    return is_drawable(pose.x, pose.y) && std::isfinite(pose.yaw);
}

/// What a picture of these points and this path has to show: the whole path, and the points without
/// the few that lie far off. At least 1 m wide and high.
[[nodiscard]] Box visible_box(const PointsView& points_map, const std::vector<Pose2>& path);

[[nodiscard]] PictureFrame fitted_frame(const Box& visible_map, int max_long_side_px);
}  // namespace rtob

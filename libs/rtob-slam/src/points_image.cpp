// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/points_image.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr double kPixel_m = 0.05, kMargin_m = 0.5, kLongestSide_pixels = 4000;

/// Everything that is to be seen, in map.
Box extent(const PointsView& points_map, const ScanTable& scans)
{
    Box box;
    const auto add = [&box](double x, double y)
    {
        box = {
            std::min(box.min_x, x), std::min(box.min_y, y), std::max(box.max_x, x),
            std::max(box.max_y, y)};
    };
    for (std::size_t i = 0; i < points_map.size; ++i) add(points_map.x[i], points_map.y[i]);
    for (std::size_t k = 0; k < scans.size(); ++k) add(scans.x(k), scans.y(k));
    return box.grown(kMargin_m);
}
}  // namespace

mrpt::img::CImage points_image(const PointsView& points_map, const ScanTable& scans)
{
    using mrpt::img::TColor;
    const Box box = extent(points_map, scans);
    const double width_m = box.max_x - box.min_x, height_m = box.max_y - box.min_y;
    const double pixel_m = std::max(kPixel_m, std::max(width_m, height_m) / kLongestSide_pixels);
    const auto column = [&](double x) { return static_cast<int>((x - box.min_x) / pixel_m); };
    const auto row = [&](double y) { return static_cast<int>((box.max_y - y) / pixel_m); };

    mrpt::img::CImage image(column(box.max_x) + 1, row(box.min_y) + 1, mrpt::img::CH_RGB);
    image.filledRectangle(
        0, 0, static_cast<int>(image.getWidth()) - 1, static_cast<int>(image.getHeight()) - 1,
        TColor::white());
    for (std::size_t i = 0; i < points_map.size; ++i)
        image.setPixel(column(points_map.x[i]), row(points_map.y[i]), TColor::black());
    for (std::size_t k = 1; k < scans.size(); ++k)
        image.line(
            column(scans.x(k - 1)), row(scans.y(k - 1)), column(scans.x(k)), row(scans.y(k)),
            TColor::red());
    return image;
}
}  // namespace rtob

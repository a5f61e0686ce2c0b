// SPDX-License-Identifier: BSD-3-Clause
#include "point_shading.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace rtob
{
namespace
{
constexpr double dot_sigma_m = 0.008;  // a return's size on the wall: keeps sparse maps visible
constexpr double darkness_of_typical = 0.8;

/// Each point shared among the four pixels whose centres surround it.
cv::Mat counted(const PointsView& points_map, const PictureFrame& frame)
{
    cv::Mat counts = cv::Mat::zeros(frame.map_px.size(), CV_32F);
    for (std::size_t i = 0; i < points_map.size; ++i)
    {
        const auto pixel = frame.pixel(points_map.x[i], points_map.y[i]);
        const double u = pixel.x - frame.map_px.x - 0.5, v = pixel.y - frame.map_px.y - 0.5;
        // Written so that NaN fails.
        if (!(u >= 0 && v >= 0 && u < counts.cols - 1 && v < counts.rows - 1)) continue;
        const int column = static_cast<int>(u), row = static_cast<int>(v);
        const auto right = static_cast<float>(u - column), below = static_cast<float>(v - row);
        float* const upper = counts.ptr<float>(row) + column;
        float* const lower = counts.ptr<float>(row + 1) + column;
        upper[0] += (1 - right) * (1 - below);
        upper[1] += right * (1 - below);
        lower[0] += (1 - right) * below;
        lower[1] += right * below;
    }
    return counts;
}

/// The median of the pixels that points touch: robust against places where the vehicle stood for an
/// hour.
double typical_count(const cv::Mat& counts)
{
    constexpr float touched = 0.05f;
    std::vector<float> values;
    for (int row = 0; row < counts.rows; ++row)
        std::copy_if(
            counts.ptr<float>(row), counts.ptr<float>(row) + counts.cols,
            std::back_inserter(values), [](float count) { return count > touched; });
    if (values.empty()) return 1;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}
}  // namespace

cv::Mat point_darkness(const PointsView& points_map, const PictureFrame& frame)
{
    cv::Mat counts = counted(points_map, frame);
    const double sigma_px = std::clamp(dot_sigma_m * frame.px_per_m, 0.4, 1.5);
    cv::GaussianBlur(counts, counts, {}, sigma_px);
    // darkness = 1 - exp(-k count): equal scans on one wall soon saturate, a lone return stays
    // faint.
    const double k = -std::log(1 - darkness_of_typical) / typical_count(counts);
    cv::Mat light;
    cv::exp(counts * -k, light);
    return 1 - light;
}

void shade_points(
    cv::Mat& picture, const PointsView& points_map, const PictureFrame& frame,
    const cv::Scalar& ink_bgr)
{
    const cv::Mat darkness = point_darkness(points_map, frame);
    cv::Mat map = picture(frame.map_px);
    for (int row = 0; row < map.rows; ++row)
    {
        const float* const dark = darkness.ptr<float>(row);
        auto* const pixels = map.ptr<cv::Vec3b>(row);
        for (int column = 0; column < map.cols; ++column)
            for (int channel = 0; channel < 3; ++channel)
            {
                auto& value = pixels[column][channel];
                value = cv::saturate_cast<uchar>(value + dark[column] * (ink_bgr[channel] - value));
            }
    }
}
}  // namespace rtob

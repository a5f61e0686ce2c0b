// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <opencv2/core/mat.hpp>
#include <string>

namespace rtob
{
/// The file holds either its old or the whole new content. Throws std::runtime_error.
void write_png(const std::string& file, const cv::Mat& picture);
}  // namespace rtob

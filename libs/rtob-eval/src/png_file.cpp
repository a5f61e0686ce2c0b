// SPDX-License-Identifier: BSD-3-Clause
#include "png_file.h"

#include <rtob/io/atomic_file.h>

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

namespace rtob
{
void write_png(const std::string& file, const cv::Mat& picture)
{
    std::vector<uchar> png;
    if (!cv::imencode(".png", picture, png))
        throw std::runtime_error("the picture " + file + " cannot be encoded");
    AtomicFile out(file);
    out.stream().write(
        reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    out.commit();
}
}  // namespace rtob

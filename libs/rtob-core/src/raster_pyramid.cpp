// SPDX-License-Identifier: BSD-3-Clause
#include "raster_pyramid.h"

#include <rtob/core/simd.h>

#include <algorithm>

namespace rtob
{
namespace
{
/// Row y of a level, from rows y and y + step of the one below.
RTOB_SIMD_CLONES void coarser_row(
    const std::uint8_t* below, const std::uint8_t* below_step, int width, int step,
    std::uint8_t* row)
{
    const auto larger = [](std::uint8_t a, std::uint8_t b) { return a < b ? b : a; };
    const int inner = std::max(0, width - step);
    for (int x = 0; x < inner; ++x)
        row[x] =
            larger(larger(below[x], below[x + step]), larger(below_step[x], below_step[x + step]));
    for (int x = inner; x < width; ++x)
        row[x] = larger(
            larger(below[x], below[width - 1]), larger(below_step[x], below_step[width - 1]));
}
}  // namespace

void draw_pyramid(std::vector<std::uint8_t>* levels, std::size_t count, int width, int height)
{
    for (std::size_t level = 1; level < count; ++level)
    {
        const int step = 1 << (level - 1);
        const auto row = [&](std::size_t of_level, int y)
        { return levels[of_level].data() + static_cast<std::ptrdiff_t>(y) * width; };
        for (int y = 0; y < height; ++y)
            coarser_row(
                row(level - 1, y), row(level - 1, std::min(y + step, height - 1)), width, step,
                row(level, y));
    }
}
}  // namespace rtob

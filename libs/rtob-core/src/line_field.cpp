// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/line_field.h>
#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr float kMinPoints = 4;
// A line's spread across is at most this share of its spread along (variances): about 1 : 3.
constexpr float kMaxFlatness = 0.1f;
}  // namespace

void LineField::reset(const NeighbourGrid& grid, double radius_m)
{
    radius_m_ = static_cast<float>(radius_m);
    lines_.reserve(grid.capacity());
    lines_.assign(grid.points().size, Line{});
}

const LineField::Line& LineField::at(const NeighbourGrid& grid, std::int32_t index)
{
    Line& line = lines_[static_cast<std::size_t>(index)];
    if (!line.known) line = fit(grid, index);
    return line;
}

LineField::Line LineField::fit(const NeighbourGrid& grid, std::int32_t index) const
{
    const PointsView points = grid.points();
    const float x = points.x[static_cast<std::size_t>(index)];
    const float y = points.y[static_cast<std::size_t>(index)];
    const NeighbourGrid::Sums sums = grid.sumsNear(x, y, radius_m_);
    Line line;
    line.known = true;
    if (sums.n < kMinPoints) return line;
    const float inv = 1.0f / sums.n;
    const float cxx = sums.xx * inv - sums.x * sums.x * inv * inv;
    const float cxy = sums.xy * inv - sums.x * sums.y * inv * inv;
    const float cyy = sums.yy * inv - sums.y * sums.y * inv * inv;
    const float mean = 0.5f * (cxx + cyy), half = 0.5f * (cxx - cyy);
    const float root = std::sqrt(half * half + cxy * cxy);
    if (!(root > 0) || mean - root > kMaxFlatness * (mean + root)) return line;
    // The line runs along the larger eigenvalue's vector, at half the angle of (half, cxy); the
    // normal stands on it.
    const float cos_of_double = half / root;
    line.normal_y = std::sqrt(std::max(0.0f, 0.5f * (1 + cos_of_double)));
    line.normal_x = std::sqrt(std::max(0.0f, 0.5f * (1 - cos_of_double)));
    if (cxy > 0) line.normal_x = -line.normal_x;
    return line;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/line_field.h>
#include <cmath>

namespace rtob
{
namespace
{
constexpr int kMinPoints = 4;
// A line's spread across is at most this share of its spread along (variances): about 1 : 3.
constexpr float kMaxFlatness = 0.1f;
}  // namespace

void LineField::reset(const NeighbourGrid& grid, double radius_m)
{
    grid_ = &grid;
    radius_m_ = static_cast<float>(radius_m);
    lines_.reserve(grid.points().x.capacity());  // as many as the grid has room for
    lines_.assign(grid.points().size(), Line{});
}

const LineField::Line& LineField::at(std::int32_t index)
{
    Line& line = lines_[static_cast<std::size_t>(index)];
    if (!line.known) line = fit(index);
    return line;
}

LineField::Line LineField::fit(std::int32_t index) const
{
    const Points& points = grid_->points();
    const float x = points.x[static_cast<std::size_t>(index)];
    const float y = points.y[static_cast<std::size_t>(index)];
    int n = 0;
    float sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
    grid_->forEachNear(
        x, y, radius_m_,
        [&](std::int32_t i)
        {
            const float dx = points.x[static_cast<std::size_t>(i)] - x;
            const float dy = points.y[static_cast<std::size_t>(i)] - y;
            if (dx * dx + dy * dy > radius_m_ * radius_m_) return;
            ++n;
            sx += dx;
            sy += dy;
            sxx += dx * dx;
            sxy += dx * dy;
            syy += dy * dy;
        });
    Line line;
    line.known = true;
    if (n < kMinPoints) return line;
    const float inv = 1.0f / static_cast<float>(n);
    const float cxx = sxx * inv - sx * sx * inv * inv;
    const float cxy = sxy * inv - sx * sy * inv * inv;
    const float cyy = syy * inv - sy * sy * inv * inv;
    const float mean = 0.5f * (cxx + cyy), half = 0.5f * (cxx - cyy);
    const float root = std::sqrt(half * half + cxy * cxy);
    if (mean - root > kMaxFlatness * (mean + root)) return line;
    // The normal is the eigenvector of the smaller eigenvalue.
    const float along_rad = 0.5f * std::atan2(cxy, half);
    line.normal_x = -std::sin(along_rad);
    line.normal_y = std::cos(along_rad);
    return line;
}
}  // namespace rtob

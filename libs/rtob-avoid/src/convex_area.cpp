// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/avoid/convex_area.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace rtob
{
namespace
{
using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

void ConvexArea::hullOf(const Vector2d* points, std::size_t count)
{
    assert(count >= 1 && count <= kMaxPoints);
    std::array<Vector2d, kMaxPoints> sorted;
    std::copy_n(points, count, sorted.begin());
    std::sort(
        sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count),
        [](const Vector2d& a, const Vector2d& b)
        { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
    // Andrew's monotone chain: the lower border from left to right, the upper one back.
    size_ = 0;
    const auto take = [&](const Vector2d& point, std::size_t keep)
    {
        while (size_ >= keep + 2 &&
               cross(corners_[size_ - 1] - corners_[size_ - 2], point - corners_[size_ - 2]) <= 0)
            --size_;
        corners_[size_++] = point;
    };
    for (std::size_t i = 0; i < count; ++i) take(sorted[i], 0);
    const std::size_t lower = size_ - 1;
    for (std::size_t i = count - 1; i-- > 0;) take(sorted[i], lower);
    if (size_ > 1) --size_;  // the first corner closes the chain
    if (size_ == 2 && corners_[0] == corners_[1]) size_ = 1;
    for (std::size_t i = 0; i < size_; ++i)
    {
        const Vector2d side = corners_[i + 1 < size_ ? i + 1 : 0] - corners_[i];
        const double length_m = side.norm();
        sides_[i].length_m = length_m;
        if (length_m > 0) sides_[i].along = side / length_m;
    }
    findCircle();
}

/// Around the middle of the corners' box.
void ConvexArea::findCircle()
{
    Vector2d low = corners_[0], high = corners_[0];
    for (const Vector2d& corner : *this)
    {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    circle_middle_ = (low + high) / 2;
    double radius2 = 0;
    for (const Vector2d& corner : *this)
        radius2 = std::max(radius2, (corner - circle_middle_).squaredNorm());
    circle_radius_m_ = std::sqrt(radius2);
}

double ConvexArea::squaredDistance(const Vector2d& place) const
{
    double nearest = std::numeric_limits<double>::infinity();
    bool is_inside = size_ > 2;
    for (std::size_t i = 0; i < size_; ++i)
    {
        const Side& side = sides_[i];
        const Vector2d from = place - corners_[i];
        const double along_m = std::clamp(from.dot(side.along), 0.0, side.length_m);
        is_inside = is_inside && cross(side.along, from) >= 0;
        nearest = std::min(nearest, (from - along_m * side.along).squaredNorm());
    }
    return is_inside ? 0 : nearest;
}

bool ConvexArea::isWithin(const Vector2d& place, double distance_m) const
{
    // Most places are farther than that from the line through one of the sides.
    for (std::size_t i = 0; i < size_; ++i)
        if (cross(sides_[i].along, place - corners_[i]) <= -distance_m) return false;
    return squaredDistance(place) < distance_m * distance_m;
}
}  // namespace rtob

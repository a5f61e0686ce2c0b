// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/avoid/near_obstacles.h>

#include <cmath>

namespace rtob
{
namespace
{
constexpr double kRounding_m = 1e-5;
}  // namespace

void NearObstacles::makeRoomFor(std::size_t more)
{
    if (x_m_.size() >= size_ + more) return;
    for (auto* numbers : {&x_m_, &y_m_, &keep_m_}) numbers->resize(size_ + more);
}

void NearObstacles::add(const NearObstacle& obstacle)
{
    makeRoomFor(1);
    x_m_[size_] = static_cast<float>(obstacle.place_vehicle.x());
    y_m_[size_] = static_cast<float>(obstacle.place_vehicle.y());
    keep_m_[size_] = static_cast<float>(obstacle.keep_m);
    ++size_;
}

void NearObstacles::add(
    const PointsView& points, const Pose2& pose_vehicle_points, double keep_m, double reach_m)
{
    makeRoomFor(points.size);
    const auto c = static_cast<float>(std::cos(pose_vehicle_points.yaw));
    const auto s = static_cast<float>(std::sin(pose_vehicle_points.yaw));
    const auto x0 = static_cast<float>(pose_vehicle_points.x);
    const auto y0 = static_cast<float>(pose_vehicle_points.y);
    const auto reach2 = static_cast<float>(reach_m * reach_m);
    const float *x_points = points.x, *y_points = points.y;
    float *x_m = x_m_.data() + size_, *y_m = y_m_.data() + size_;
    int within = 0;
    for (std::size_t i = 0; i < points.size; ++i)
    {
        x_m[i] = x0 + c * x_points[i] - s * y_points[i];
        y_m[i] = y0 + s * x_points[i] + c * y_points[i];
        within += x_m[i] * x_m[i] + y_m[i] * y_m[i] < reach2 ? 1 : 0;
    }
    const std::size_t begin = size_;
    size_ += points.size;
    if (static_cast<std::size_t>(within) < points.size) dropBeyond(begin, reach2);
    const auto at = [&](std::size_t i) { return keep_m_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::fill(at(begin), at(size_), static_cast<float>(keep_m));
}

/// Written in any case, and overwritten where it is too far: no branch to be mispredicted.
void NearObstacles::dropBeyond(std::size_t begin, float reach2)
{
    std::size_t kept = begin;
    for (std::size_t i = begin; i < size_; ++i)
    {
        const float x = x_m_[i], y = y_m_[i];
        x_m_[kept] = x;
        y_m_[kept] = y;
        kept += x * x + y * y < reach2 ? 1 : 0;
    }
    size_ = kept;
}

/// Those near the circle around an area; a little more, for rounding. Several at a time.
bool NearObstacles::findCandidates(
    const ConvexArea& area, std::size_t begin, std::size_t count,
    std::array<bool, kPortion>& may_be_in) const
{
    const auto middle_x = static_cast<float>(area.circleMiddle().x());
    const auto middle_y = static_cast<float>(area.circleMiddle().y());
    const auto radius_m = static_cast<float>(area.circleRadius() + kRounding_m);
    const float *x_m = x() + begin, *y_m = y() + begin, *keep_m = keep() + begin;
    int found = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        const float dx = x_m[i] - middle_x, dy = y_m[i] - middle_y, far_m = radius_m + keep_m[i];
        const bool is_near = dx * dx + dy * dy < far_m * far_m;
        may_be_in[i] = is_near;
        found += is_near ? 1 : 0;
    }
    return found > 0;
}

void NearObstacles::addThoseIn(const ConvexArea& area, const NearObstacles& others)
{
    others.forEachIn(area, [&](std::size_t i) { return add(others.at(i)), true; });
}

void NearObstacles::excuse(const ConvexArea& area, NearObstacles& excused)
{
    const auto excuse_one = [&](std::size_t i)
    {
        excused.add(at(i));
        const double distance_m = std::sqrt(area.squaredDistance(at(i).place_vehicle));
        keep_m_[i] = static_cast<float>(distance_m - kRounding_m);
        return true;
    };
    forEachIn(area, excuse_one);
}

bool NearObstacles::anyIsIn(const ConvexArea& area) const
{
    bool any = false;
    forEachIn(area, [&](std::size_t) { return !(any = true); });
    return any;
}

bool NearObstacles::anyIsAhead(const Eigen::Vector2d& direction) const
{
    const auto x_ahead = static_cast<float>(direction.x());
    const auto y_ahead = static_cast<float>(direction.y());
    int ahead = 0;  // counted to the end, several at a time
    for (std::size_t i = 0; i < size_; ++i) ahead += x_ahead * x_m_[i] + y_ahead * y_m_[i] > 0;
    return ahead > 0;
}
}  // namespace rtob

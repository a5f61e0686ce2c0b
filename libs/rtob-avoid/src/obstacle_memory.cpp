// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/avoid/obstacle_memory.h>

#include <cmath>

namespace rtob
{
namespace
{
// Room for the beams of a large scan that come on top before update() makes room.
constexpr std::size_t kScanPoints = 2048;

template <class Values>
void drop_first(Values& values, std::size_t count)
{
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
}
}  // namespace

ObstacleMemory::ObstacleMemory(const GuardOptions& options)
    : memory_s_(options.memory_s),
      range_m_(static_cast<float>(options.memory_range_m)),
      capacity_(static_cast<std::size_t>(options.memory_points))
{
    points_map_.reserve(capacity_ + kScanPoints);
    seen_s_.reserve(capacity_ + kScanPoints);
}

void ObstacleMemory::clear()
{
    points_map_.clear();
    seen_s_.clear();
}

void ObstacleMemory::add(const ScanPicture& picture, const Pose2& pose_map_vehicle, double time_s)
{
    const auto c = static_cast<float>(std::cos(pose_map_vehicle.yaw));
    const auto s = static_cast<float>(std::sin(pose_map_vehicle.yaw));
    const auto x0 = static_cast<float>(pose_map_vehicle.x);
    const auto y0 = static_cast<float>(pose_map_vehicle.y);
    const Points& hits = picture.hits();
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        points_map_.add(x0 + c * hits.x[i] - s * hits.y[i], y0 + s * hits.x[i] + c * hits.y[i]);
        seen_s_.push_back(time_s);
    }
}

void ObstacleMemory::update(
    const ScanPicture& picture, const Pose2& pose_map_vehicle, double time_s)
{
    const Pose2 pose_vehicle_map = inverse(pose_map_vehicle);
    const auto c = static_cast<float>(std::cos(pose_vehicle_map.yaw));
    const auto s = static_cast<float>(std::sin(pose_vehicle_map.yaw));
    const auto x0 = static_cast<float>(pose_vehicle_map.x);
    const auto y0 = static_cast<float>(pose_vehicle_map.y);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points_map_.size(); ++i)
    {
        const float x_map = points_map_.x[i], y_map = points_map_.y[i];
        const float x = x0 + c * x_map - s * y_map, y = y0 + s * x_map + c * y_map;
        if (time_s - seen_s_[i] > memory_s_ || x * x + y * y > range_m_ * range_m_) continue;
        if (picture.sightOf(x, y) != Sight::Hidden) continue;
        points_map_.x[kept] = x_map;
        points_map_.y[kept] = y_map;
        seen_s_[kept] = seen_s_[i];
        ++kept;
    }
    points_map_.x.resize(kept);
    points_map_.y.resize(kept);
    seen_s_.resize(kept);
    if (kept <= capacity_) return;
    drop_first(points_map_.x, kept - capacity_);
    drop_first(points_map_.y, kept - capacity_);
    drop_first(seen_s_, kept - capacity_);
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/travel_log.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr std::size_t kScanBlock = 1 << 12;  // memory grows seldom, as the map's does
constexpr float kLongPath_m = 1 << 16;       // where a float still tells centimetres
}  // namespace

void TravelLog::inserted(const Pose2& pose_map_vehicle)
{
    const double step_m =
        std::hypot(pose_map_vehicle.x - last_pose_.x, pose_map_vehicle.y - last_pose_.y);
    if (path_m_.size() == path_m_.capacity())
        path_m_.reserve(std::max(2 * path_m_.size(), kScanBlock));
    path_m_.push_back(path_m_.empty() ? 0.0f : path_m_.back() + static_cast<float>(step_m));
    last_pose_ = pose_map_vehicle;
}

void TravelLog::keepOnly(const std::vector<char>& keep)
{
    std::size_t kept = 0;
    for (std::size_t scan = 0; scan < path_m_.size(); ++scan)
        if (keep[scan] != 0) path_m_[kept++] = path_m_[scan];
    path_m_.resize(kept);
    if (path_m_.empty() || path_m_.back() < kLongPath_m) return;
    // What is older than half of that is old, by how much is not told apart any more.
    const float shift_m = path_m_.back() - kLongPath_m / 2;
    for (float& path_m : path_m_) path_m = std::max(0.0f, path_m - shift_m);
    before_m_ += shift_m;
}

std::size_t TravelLog::scansBefore(double travel_m) const
{
    const auto limit_m = static_cast<float>(path() - before_m_ - travel_m);
    return static_cast<std::size_t>(
        std::lower_bound(path_m_.begin(), path_m_.end(), limit_m) - path_m_.begin());
}
}  // namespace rtob

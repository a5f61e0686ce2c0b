// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/avoid/command_log.h>

#include <algorithm>

namespace rtob
{
using Eigen::Vector2d;

void CommandLog::add(double time_s, const Vector2d& velocity_odom)
{
    commands_[next_] = {time_s, velocity_odom};
    next_ = (next_ + 1) % kCapacity;
    size_ = std::min(size_ + 1, kCapacity);
}

std::size_t CommandLog::acting(
    double now_s, std::array<Vector2d, kMaxActing>& velocities_odom) const
{
    std::size_t count = 0;
    while (count < size_ && command(count).time_s > now_s - latency_s_) ++count;
    count = std::min(count + 1, size_);  // the one before acts until those do
    if (count == 0) return 0;
    if (count <= kMaxActing)
    {
        for (std::size_t i = 0; i < count; ++i) velocities_odom[i] = command(i).velocity_odom;
        return count;
    }
    Vector2d low = command(0).velocity_odom, high = low;
    for (std::size_t i = 1; i < count; ++i)
    {
        low = low.cwiseMin(command(i).velocity_odom);
        high = high.cwiseMax(command(i).velocity_odom);
    }
    velocities_odom[0] = low;
    velocities_odom[1] = {high.x(), low.y()};
    velocities_odom[2] = high;
    velocities_odom[3] = {low.x(), high.y()};
    return 4;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/avoid/stopping_area.h>

#include <algorithm>
#include <cassert>

namespace rtob
{
using Eigen::Vector2d;

StoppingArea::StoppingArea(const VehicleLimits& options)
    : latency_s_(options.latency_s),
      response_s_(options.response()),
      period_s_(options.period_s),
      braking_mps2_(options.braking())
{
    const Vector2d standing = Vector2d::Zero();
    setActing(&standing, 1);
}

void StoppingArea::setActing(const Vector2d* velocities, std::size_t count)
{
    assert(count >= 1 && count <= kMaxVelocities);
    acting_.hullOf(velocities, count);
    fastest_acting_mps_ = 0;
    for (const Vector2d& old : acting_)
        fastest_acting_mps_ = std::max(fastest_acting_mps_, old.norm());
}

double StoppingArea::totalTime(double fastest_mps) const
{
    return latency_s_ + period_s_ + response_s_ + fastest_mps / (2 * braking_mps2_);
}

double StoppingArea::oldTime(const Vector2d& command) const
{
    double change_mps = 0;
    for (const Vector2d& old : acting_)
        change_mps = std::max({change_mps, (old - command).norm(), old.norm()});
    // The quarter: braking may begin before the change of velocity is complete.
    return latency_s_ + response_s_ + (change_mps + command.norm() / 4) / (2 * braking_mps2_);
}

ConvexArea StoppingArea::of(const Vector2d& command) const
{
    const double total_s = totalTime(std::max(fastest_acting_mps_, command.norm()));
    const double old_s = std::min(oldTime(command), total_s);
    std::array<Vector2d, ConvexArea::kMaxPoints> corners;
    std::size_t count = 0;
    corners[count++] = Vector2d::Zero();
    corners[count++] = total_s * command;
    for (const Vector2d& old : acting_)
    {
        corners[count++] = old_s * old;
        corners[count++] = old_s * old + (total_s - old_s) * command;
    }
    ConvexArea area;
    area.hullOf(corners.data(), count);
    return area;
}

ConvexArea StoppingArea::ofUpTo(const Vector2d& command) const
{
    const double total_s = totalTime(std::max(fastest_acting_mps_, command.norm()));
    std::array<Vector2d, ConvexArea::kMaxPoints> corners;
    std::size_t count = 0;
    corners[count++] = Vector2d::Zero();
    corners[count++] = total_s * command;
    for (const Vector2d& old : acting_)
    {
        corners[count++] = total_s * old;
        corners[count++] = total_s * (old + command);
    }
    ConvexArea area;
    area.hullOf(corners.data(), count);
    return area;
}

double StoppingArea::reach(double speed_mps) const
{
    const double fastest_mps = std::max(speed_mps, fastest_acting_mps_);
    return fastest_mps * totalTime(fastest_mps);
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/avoid/dead_reckoning.h>

#include <algorithm>

namespace rtob
{
namespace
{
/// The pose after moving on with a constant motion, seen along the middle of the turn.
Pose2 moved_on(const Pose2& pose_odom_vehicle, const VehicleMotion& motion, double duration_s)
{
    const double turn_rad = motion.yaw_rate_radps * duration_s;
    const Pose2 middle{
        pose_odom_vehicle.x, pose_odom_vehicle.y, pose_odom_vehicle.yaw + turn_rad / 2};
    const Eigen::Vector2d step = motion.velocity_vehicle * duration_s;
    return compose(middle, {step.x(), step.y(), turn_rad / 2});
}

VehicleMotion mean_of(const VehicleMotion& a, const VehicleMotion& b)
{
    return {
        (a.velocity_vehicle + b.velocity_vehicle) / 2, (a.yaw_rate_radps + b.yaw_rate_radps) / 2};
}

Pose2 between_poses(const Pose2& a, const Pose2& b, double share)
{
    return {
        a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
        wrap_angle(a.yaw + share * wrap_angle(b.yaw - a.yaw))};
}
}  // namespace

void DeadReckoning::push(const Sample& added)
{
    samples_[next_] = added;
    next_ = (next_ + 1) % kCapacity;
    size_ = std::min(size_ + 1, kCapacity);
}

bool DeadReckoning::add(double time_s, const VehicleMotion& motion)
{
    if (size_ == 0)
    {
        push({time_s, motion, {}});
        return true;
    }
    const Sample& last = sample(0);
    const double step_s = time_s - last.time_s;
    if (step_s < 0 || step_s > kLongestGap_s)
    {
        size_ = 0;
        push({time_s, motion, {}});
        return false;
    }
    push({time_s, motion, moved_on(last.pose_odom_vehicle, mean_of(last.motion, motion), step_s)});
    return true;
}

std::optional<Pose2> DeadReckoning::poseAt(double time_s) const
{
    if (size_ == 0) return std::nullopt;
    const Sample& newest = sample(0);
    if (time_s >= newest.time_s)
    {
        const double ahead_s = time_s - newest.time_s;
        if (!(ahead_s <= kLongestGap_s)) return std::nullopt;
        return moved_on(newest.pose_odom_vehicle, newest.motion, ahead_s);
    }
    for (std::size_t back = 1; back < size_; ++back)
    {
        const Sample &before = sample(back), &after = sample(back - 1);
        if (!(time_s >= before.time_s)) continue;
        const double share = (time_s - before.time_s) / (after.time_s - before.time_s);
        return between_poses(before.pose_odom_vehicle, after.pose_odom_vehicle, share);
    }
    // Before the first measurement the vehicle is taken to have moved as it did then.
    const Sample& oldest = sample(size_ - 1);
    if (!(oldest.time_s - time_s <= kLongestGap_s) || size_ == kCapacity) return std::nullopt;
    return moved_on(oldest.pose_odom_vehicle, oldest.motion, time_s - oldest.time_s);
}
}  // namespace rtob

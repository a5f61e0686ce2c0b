// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/pose_carrier.h>

#include <cmath>

namespace rtob
{
namespace
{
/// What a vehicle may do unseen within the time: accelerations of 3 m/s^2 and 3 rad/s^2.
constexpr double kAcceleration_mps2 = 3, kTurnAcceleration_radps2 = 3;
/// Below this a surprise is no jump but noise.
constexpr double kJump_m = 0.2, kJump_rad = 0.15;
/// Two scans farther apart tell no velocity.
constexpr double kLongestStep_s = 1;

Pose2 scaled(const Pose2& velocity, double step_s)
{
    return {velocity.x * step_s, velocity.y * step_s, velocity.yaw * step_s};
}

bool is_jump(const Pose2& pose_expected_found, double step_s)
{
    const double unseen_m = 0.5 * kAcceleration_mps2 * step_s * step_s;
    const double unseen_rad = 0.5 * kTurnAcceleration_radps2 * step_s * step_s;
    return std::hypot(pose_expected_found.x, pose_expected_found.y) > kJump_m + 2 * unseen_m ||
           std::abs(pose_expected_found.yaw) > kJump_rad + 2 * unseen_rad;
}
}  // namespace

void PoseCarrier::matched(
    double time_s, const Pose2& pose_map_vehicle, const Eigen::Matrix3d& covariance)
{
    TimedPose now{time_s, pose_map_vehicle, covariance, {}, 0};
    bool jumped = was_lost_ && last_;
    bool has_velocity = false;
    if (last_ && !was_lost_)
    {
        const double step_s = time_s - last_->time_s;
        if (step_s <= 0) return;  // of the past, or said before
        const Pose2 expected =
            compose(last_->pose_map_vehicle, scaled(last_->velocity_vehicle, step_s));
        jumped = has_velocity_ && is_jump(between(expected, pose_map_vehicle), step_s);
        has_velocity = !jumped && step_s < kLongestStep_s;
        if (has_velocity)
            now.velocity_vehicle =
                scaled(between(last_->pose_map_vehicle, pose_map_vehicle), 1 / step_s);
    }
    if (jumped) ++resets_;
    now.resets = resets_;
    last_ = now;
    has_velocity_ = has_velocity;
    was_lost_ = false;
}

void PoseCarrier::lost()
{
    was_lost_ = true;
    has_velocity_ = false;
}

std::optional<TimedPose> PoseCarrier::at(double time_s) const
{
    if (!last_ || was_lost_) return std::nullopt;
    const double step_s = time_s - last_->time_s;
    if (step_s < 0 || step_s > max_s_) return std::nullopt;
    TimedPose pose = *last_;
    pose.time_s = time_s;
    pose.pose_map_vehicle =
        compose(last_->pose_map_vehicle, scaled(last_->velocity_vehicle, step_s));
    const double unseen_m = 0.5 * kAcceleration_mps2 * step_s * step_s;
    const double unseen_rad = 0.5 * kTurnAcceleration_radps2 * step_s * step_s;
    pose.covariance.diagonal() +=
        Eigen::Vector3d(unseen_m * unseen_m, unseen_m * unseen_m, unseen_rad * unseen_rad);
    return pose;
}
}  // namespace rtob

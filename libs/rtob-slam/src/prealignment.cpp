// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <rtob/core/option_checks.h>
#include <rtob/slam/prealignment.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr double kLongestStep_s = 1.0;  // a velocity is not carried on for longer
}

void PrealignOptions::validate() const
{
    require(max_speed_mps > 0, "max_speed_mps", max_speed_mps, "> 0");
    require(max_turn_degps > 0, "max_turn_degps", max_turn_degps, "> 0");
}

Prealignment::Prealignment(const PrealignOptions& options) : options_(options)
{
    options_.validate();
}

void Prealignment::addOdometry(const Pose2& pose_odom_vehicle)
{
    if (!odometry_at_last_) odometry_at_last_ = pose_odom_vehicle;
    odometry_now_ = pose_odom_vehicle;
    odometry_is_new_ = true;
}

void Prealignment::addMotion(const Pose2& pose_prev_now)
{
    addOdometry(compose(odometry_now_.value_or(Pose2{}), pose_prev_now));
}

Pose2 Prealignment::carriedOn(double step_s) const
{
    if (!(step_s > 0)) return {};
    const double s = std::min(step_s, kLongestStep_s);
    return {velocity_.x * s, velocity_.y * s, velocity_.yaw * s};
}

Pose2 Prealignment::predict(double stamp_s) const
{
    const bool wants_odometry =
        options_.source == PrealignSource::Auto || options_.source == PrealignSource::Odometry;
    if (wants_odometry && odometry_is_new_)
        return compose(pose_map_last_, between(*odometry_at_last_, *odometry_now_));
    const bool wants_velocity = options_.source == PrealignSource::Auto ||
                                options_.source == PrealignSource::ConstantVelocity;
    if (wants_velocity && started_)
        return compose(pose_map_last_, carriedOn(stamp_s - last_stamp_s_));
    return pose_map_last_;
}

void Prealignment::settle(double stamp_s, const Pose2& pose_map_vehicle, bool matched)
{
    const double step_s = stamp_s - last_stamp_s_;
    if (started_ && matched && step_s > 0 && step_s <= kLongestStep_s)
    {
        const Pose2 moved = between(pose_map_last_, pose_map_vehicle);
        const Pose2 velocity{moved.x / step_s, moved.y / step_s, moved.yaw / step_s};
        const bool plausible = std::hypot(velocity.x, velocity.y) <= options_.max_speed_mps &&
                               std::abs(velocity.yaw) <= mrpt::DEG2RAD(options_.max_turn_degps);
        velocity_ = plausible ? velocity : Pose2{};
    }
    else if (!matched || step_s > kLongestStep_s)
        velocity_ = {};
    pose_map_last_ = pose_map_vehicle;
    last_stamp_s_ = stamp_s;
    started_ = true;
    odometry_at_last_ = odometry_now_;
    odometry_is_new_ = false;
}

void Prealignment::reset(const Pose2& pose_map_vehicle)
{
    pose_map_last_ = pose_map_vehicle;
    velocity_ = {};
    odometry_at_last_ = odometry_now_;
    odometry_is_new_ = false;
    started_ = false;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <rtob/core/option_checks.h>
#include <rtob/slam/prealignment.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtob
{
namespace
{
constexpr double kLongestStep_s = 1.0;  // a velocity is not carried on for longer
// Of the usual step: what is believed of one, and what one may add to the mean.
constexpr double kShortestStep = 0.5, kLongestStep = 2, kOutlierStep = 3;
constexpr double kStepMemory = 0.05;  // the mean forgets within some twenty scans
// Along walls without any mark the information of a pair is less than this: the noise of their
// normals [rad^2]. Measured in bare corridors of the simulator: 0.75e-4 to 1.3e-4; in real ones at
// least 1e-3.
constexpr double kFeignedInformation = 2e-4;
}  // namespace

Eigen::Matrix3d velocity_shown(const IcpResult& fit)
{
    Eigen::Matrix3d shown = Eigen::Matrix3d::Identity();
    const Eigen::Matrix2d h = fit.information.topLeftCorner<2, 2>();
    if (fit.pairs == 0 || !(h.trace() > 0)) return shown;
    const WeakDirection weak = weak_direction(fit.information);
    const double a_pair = weak.share * h.trace() / static_cast<double>(fit.pairs);
    const double marks = std::pow(a_pair / kFeignedInformation, 4);
    const Eigen::Vector2d along(std::cos(weak.angle_rad), std::sin(weak.angle_rad));
    shown.topLeftCorner<2, 2>() -= along * along.transpose() / (1 + marks);
    return shown;
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
    if (!is_finite(pose_odom_vehicle)) return;
    // What was driven before the first scan is no part of the map.
    if (!started_ || !odometry_at_last_) odometry_at_last_ = pose_odom_vehicle;
    odometry_now_ = pose_odom_vehicle;
    odometry_is_new_ = true;
}

void Prealignment::addMotion(const Pose2& pose_prev_now)
{
    if (!odometry_now_) addOdometry({});  // so that the first motion is one from somewhere
    if (is_finite(pose_prev_now)) addOdometry(compose(*odometry_now_, pose_prev_now));
}

/// Stamps of real logs jitter, repeat, step back and jump. A velocity over a step that is a
/// hundredth of the true one would throw the next guess metres off, so what is far from usual is
/// not believed.
double Prealignment::stepTo(double stamp_s) const
{
    const double step_s = stamp_s - time_s_;
    if (!(step_s > 0 && step_s <= kLongestStep_s)) return usual_step_s_;
    if (!(usual_step_s_ > 0)) return step_s;
    return std::clamp(step_s, kShortestStep * usual_step_s_, kLongestStep * usual_step_s_);
}

/// The time goes on with the stamps; where they step back a little, by the usual step.
void Prealignment::advanceTime(double stamp_s)
{
    const double step_s = stamp_s - time_s_;
    const bool goes_on = std::abs(step_s) <= kLongestStep_s;
    const double believed_s = goes_on && step_s > 0 ? step_s : usual_step_s_;
    time_s_ = goes_on ? time_s_ + believed_s : stamp_s;
    if (!(usual_step_s_ > 0))
        usual_step_s_ = goes_on ? believed_s : 0;
    else
        usual_step_s_ +=
            kStepMemory * (std::min(believed_s, kOutlierStep * usual_step_s_) - usual_step_s_);
}

Pose2 Prealignment::carriedOn(double step_s) const
{
    return {velocity_.x * step_s, velocity_.y * step_s, velocity_.yaw * step_s};
}

bool Prealignment::goesByOdometry() const
{
    const bool wants_odometry =
        options_.source == PrealignSource::Auto || options_.source == PrealignSource::Odometry;
    return wants_odometry && odometry_is_new_;
}

Pose2 Prealignment::predict(double stamp_s) const
{
    if (goesByOdometry())
        return compose(pose_map_last_, between(*odometry_at_last_, *odometry_now_));
    const bool wants_velocity = options_.source == PrealignSource::Auto ||
                                options_.source == PrealignSource::ConstantVelocity;
    if (wants_velocity) return compose(pose_map_last_, carriedOn(stepTo(stamp_s)));
    return pose_map_last_;
}

Twist2 Prealignment::twist(double stamp_s) const
{
    if (!started_) return {};
    const Pose2 velocity = velocityOver(stepTo(stamp_s), predict(stamp_s));
    return {velocity.x, velocity.y, velocity.yaw};
}

void Prealignment::settle(
    double stamp_s, const Pose2& pose_map_vehicle, bool matched, const Eigen::Matrix3d& believed)
{
    const double step_s = stepTo(stamp_s);
    const bool is_pause = stamp_s - time_s_ > kLongestStep_s;
    velocity_ = started_ && matched && !is_pause
                    ? blended(velocityOver(step_s, pose_map_vehicle), believed)
                    : Pose2{};
    advanceTime(stamp_s);
    pose_map_last_ = pose_map_vehicle;
    started_ = true;
    odometry_at_last_ = odometry_now_;
    odometry_is_new_ = false;
}

/// Over the step to this pose; none where it cannot be true.
Pose2 Prealignment::velocityOver(double step_s, const Pose2& pose_map_vehicle) const
{
    if (!(step_s > 0)) return {};
    const Pose2 moved = between(pose_map_last_, pose_map_vehicle);
    const Pose2 velocity{moved.x / step_s, moved.y / step_s, moved.yaw / step_s};
    const bool plausible = std::hypot(velocity.x, velocity.y) <= options_.max_speed_mps &&
                           std::abs(velocity.yaw) <= mrpt::DEG2RAD(options_.max_turn_degps);
    return plausible ? velocity : Pose2{};
}

/// The velocity of before with what is believed of the new one.
Pose2 Prealignment::blended(const Pose2& measured, const Eigen::Matrix3d& believed) const
{
    Eigen::Matrix3d to_map = Eigen::Matrix3d::Identity();
    to_map.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(pose_map_last_.yaw).toRotationMatrix();
    const Eigen::Vector3d before(velocity_.x, velocity_.y, velocity_.yaw);
    const Eigen::Vector3d now(measured.x, measured.y, measured.yaw);
    const Eigen::Vector3d velocity =
        before + to_map.transpose() * believed * to_map * (now - before);
    return {velocity.x(), velocity.y(), velocity.z()};
}

void Prealignment::reset(const Pose2& pose_map_vehicle)
{
    pose_map_last_ = pose_map_vehicle;
    velocity_ = {};
    odometry_at_last_ = odometry_now_;
    odometry_is_new_ = false;
    time_s_ = std::numeric_limits<double>::quiet_NaN();
    started_ = true;
}
}  // namespace rtob

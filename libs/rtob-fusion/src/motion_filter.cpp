// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/fusion/motion_filter.h>

#include <algorithm>

namespace rtob
{
namespace
{
constexpr double kRadPerDeg = 3.14159265358979323846 / 180;
constexpr std::size_t kMostKept = 1024;  // readings; bounds memory and the time of a replay

FusionOptions validated(const FusionOptions& options)
{
    options.validate();
    return options;
}
}  // namespace

MotionFilter::MotionFilter(const FusionOptions& options)
    : history_s_(validated(options).history_s),
      noise_{
          options.speed_change_mps, kRadPerDeg * options.turn_change_degps,
          kRadPerDeg * options.gyro_drift_degps},
      gate_(options.gate_chance),
      gyro_bias_radps_(kRadPerDeg * options.gyro_bias_degps),
      steps_(kMostKept)
{
}

void MotionFilter::start(
    double time_s, const Pose2& pose_map_vehicle, const Eigen::Matrix3d& covariance,
    const UnknownMotion& motion)
{
    steps_.clear();
    oldest_ = MotionState();
    oldest_.time_s = time_s;
    oldest_.mean.head<3>() << pose_map_vehicle.x, pose_map_vehicle.y, pose_map_vehicle.yaw;
    oldest_.covariance.topLeftCorner<3, 3>() = covariance;
    oldest_.covariance(kForward, kForward) = motion.speed_mps * motion.speed_mps;
    oldest_.covariance(kLeft, kLeft) = motion.speed_mps * motion.speed_mps;
    oldest_.covariance(kTurn, kTurn) = motion.turn_radps * motion.turn_radps;
    oldest_.covariance(kGyroBias, kGyroBias) = gyro_bias_radps_ * gyro_bias_radps_;
    started_ = true;
}

const MotionState& MotionFilter::before(Steps::const_iterator step) const
{
    return step == steps_.begin() ? oldest_ : std::prev(step)->after;
}

double MotionFilter::newest() const
{
    return before(steps_.end()).time_s;
}

/// Behind all that are not later.
MotionFilter::Steps::iterator MotionFilter::insert(const Measurement& measurement)
{
    const auto place = std::upper_bound(
        steps_.begin(), steps_.end(), measurement.time_s,
        [](double time_s, const Step& step) { return time_s < step.measurement.time_s; });
    return steps_.insert(place, Step{measurement, {}});
}

/// @return what became of the first
Innovation MotionFilter::replay(Steps::iterator from)
{
    Innovation first;
    for (auto step = from; step != steps_.end(); ++step)
    {
        step->after = before(step);
        predict(step->after, step->measurement.time_s, noise_);
        const Innovation innovation = update(step->after, step->measurement, gate_);
        if (step == from) first = innovation;
    }
    return first;
}

void MotionFilter::forget(std::size_t count)
{
    if (count == 0) return;
    oldest_ = steps_[count - 1].after;
    steps_.erase_begin(count);
}

void MotionFilter::forgetOld()
{
    const double since_s = newest() - history_s_;
    std::size_t count = 0;
    while (count < steps_.size() && steps_[count].measurement.time_s < since_s) ++count;
    forget(count);
}

std::optional<Innovation> MotionFilter::add(const Measurement& measurement)
{
    if (steps_.full()) forget(1);
    if (measurement.time_s < oldest_.time_s) return std::nullopt;
    const Innovation innovation = replay(insert(measurement));
    forgetOld();
    return innovation;
}

std::optional<Innovation> MotionFilter::addPose(const Measurement& pose)
{
    if (steps_.full()) forget(1);
    if (pose.time_s < oldest_.time_s) return std::nullopt;
    const auto step = insert(pose);
    const Innovation innovation = replay(step);
    if (!innovation.used)
    {
        step->measurement.kind = Measurement::Kind::Place;
        replay(step);
    }
    forgetOld();
    return innovation;
}

MotionState MotionFilter::at(double time_s) const
{
    const auto later = std::upper_bound(
        steps_.begin(), steps_.end(), time_s,
        [](double time, const Step& step) { return time < step.measurement.time_s; });
    MotionState state = before(later);
    predict(state, time_s, noise_);
    return state;
}
}  // namespace rtob

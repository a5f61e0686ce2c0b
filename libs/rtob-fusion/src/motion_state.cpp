// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/fusion/motion_state.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr double kLongestStep_s = 0.02;  // the path is taken for straight over one step

/// The derivative of the state after a step by the state before it, with the mean moved on.
MotionMatrix move_on(MotionVector& mean, double dt_s)
{
    const double yaw_midway = mean[kYaw] + 0.5 * dt_s * mean[kTurn];
    const double c = std::cos(yaw_midway), s = std::sin(yaw_midway);
    const double dx = dt_s * (c * mean[kForward] - s * mean[kLeft]);
    const double dy = dt_s * (s * mean[kForward] + c * mean[kLeft]);
    MotionMatrix derivative = MotionMatrix::Identity();
    derivative(kX, kYaw) = -dy;
    derivative(kY, kYaw) = dx;
    derivative(kX, kForward) = derivative(kY, kLeft) = c * dt_s;
    derivative(kX, kLeft) = -s * dt_s;
    derivative(kY, kForward) = s * dt_s;
    derivative(kX, kTurn) = -0.5 * dt_s * dy;
    derivative(kY, kTurn) = 0.5 * dt_s * dx;
    derivative(kYaw, kTurn) = dt_s;
    mean[kX] += dx;
    mean[kY] += dy;
    mean[kYaw] += dt_s * mean[kTurn];
    return derivative;
}

/// What white noise in a rate's derivative does to the rate and to its integral over a step.
void add_noise(
    MotionMatrix& covariance, const MotionMatrix& derivative, MotionIndex rate, double density,
    double dt_s)
{
    const double variance = density * density * dt_s;
    // The rate's column holds dt_s times the way in which its integral moves the pose.
    Eigen::Vector3d way = derivative.col(rate).head<3>();
    if (rate == kTurn) way.head<2>().setZero();  // of third order in the step
    covariance.topLeftCorner<3, 3>() += variance / 3 * way * way.transpose();
    covariance.block<3, 1>(0, rate) += variance / 2 * way;
    covariance.block<1, 3>(rate, 0) += variance / 2 * way.transpose();
    covariance(rate, rate) += variance;
}

void step(MotionState& state, double dt_s, const MotionNoise& noise)
{
    const MotionMatrix derivative = move_on(state.mean, dt_s);
    state.covariance = derivative * state.covariance * derivative.transpose();
    add_noise(state.covariance, derivative, kForward, noise.speed_change, dt_s);
    add_noise(state.covariance, derivative, kLeft, noise.speed_change, dt_s);
    add_noise(state.covariance, derivative, kTurn, noise.turn_change, dt_s);
    state.covariance(kGyroBias, kGyroBias) +=
        noise.gyro_bias_change * noise.gyro_bias_change * dt_s;
}
}  // namespace

Pose2 carried(const Twist2& twist, double time_s)
{
    const double angle = twist.turn_radps * time_s;
    // sin(a)/a and (1 - cos(a))/a, by their series where the quotient has no digits left
    const bool is_small = std::abs(angle) < 1e-4;
    const double along = is_small ? 1 - angle * angle / 6 : std::sin(angle) / angle;
    const double aside = is_small ? angle / 2 : (1 - std::cos(angle)) / angle;
    const double x = twist.forward_mps * time_s, y = twist.left_mps * time_s;
    return {along * x - aside * y, aside * x + along * y, wrap_angle(angle)};
}

void predict(MotionState& state, double time_s, const MotionNoise& noise)
{
    const double span_s = time_s - state.time_s;
    if (!(span_s > 0)) return;
    const double steps = std::ceil(span_s / kLongestStep_s);
    for (double i = 0; i < steps; ++i) step(state, span_s / steps, noise);
    state.time_s = time_s;
}
}  // namespace rtob

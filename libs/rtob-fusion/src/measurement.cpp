// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/fusion/measurement.h>
#include <Eigen/Cholesky>

#include <cmath>

namespace rtob
{
namespace
{
using Kind = Measurement::Kind;

int freedom_of(Kind kind)
{
    switch (kind)
    {
        case Kind::YawRate:
            return 1;
        case Kind::Velocity:
            return 2;
        case Kind::WayBegin:
            return 0;
        default:
            return 3;
    }
}

// One to three rows, sized at run time: fixed sizes would be compiled thrice, unrolled.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, kMotionSize, 0, 3, kMotionSize>;
using Residual = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

/// That a chi-square variable of 1, 2 or 3 degrees of freedom is larger than this.
double chance_of_more(double value, int freedom)
{
    if (freedom == 2) return std::exp(-0.5 * value);
    const double chance = std::erfc(std::sqrt(0.5 * value));
    constexpr double two_by_pi = 0.63661977236758134308;
    return freedom == 1 ? chance : chance + std::sqrt(two_by_pi * value) * std::exp(-0.5 * value);
}

/// @param residual measured less expected
/// @param derivative of what is expected, by the state
Innovation update_linear(
    MotionState& state, const Residual& residual, const Rows& derivative, const Measurement& m,
    const NisGate& gate)
{
    const auto rows = residual.size();
    const Rows crossed = derivative.lazyProduct(state.covariance);
    const Square spread =
        crossed.lazyProduct(derivative.transpose()) + m.covariance.topLeftCorner(rows, rows);
    const Eigen::LDLT<Square> solver(spread);
    Innovation innovation{residual.dot(solver.solve(residual)), static_cast<int>(rows), true};
    innovation.used = innovation.nis <= gate.limit[static_cast<std::size_t>(rows)];
    if (!innovation.used) return innovation;
    const Rows gain_transposed = solver.solve(crossed);
    state.mean += gain_transposed.transpose().lazyProduct(residual);
    state.covariance -= crossed.transpose().lazyProduct(gain_transposed);
    // Rounding must not let the two halves drift apart.
    state.covariance = 0.5 * (state.covariance + state.covariance.transpose()).eval();
    return innovation;
}

Innovation update_yaw_rate(MotionState& state, const Measurement& m, const NisGate& gate)
{
    Rows derivative = Rows::Zero(1, kMotionSize);
    derivative(0, kTurn) = derivative(0, kGyroBias) = 1;
    Residual residual(1);
    residual[0] = m.value[0] - state.mean[kTurn] - state.mean[kGyroBias];
    return update_linear(state, residual, derivative, m, gate);
}

Innovation update_velocity(MotionState& state, const Measurement& m, const NisGate& gate)
{
    Rows derivative = Rows::Zero(2, kMotionSize);
    derivative(0, kForward) = derivative(1, kLeft) = 1;
    const Eigen::Vector2d residual = m.value.head<2>() - state.mean.segment<2>(kForward);
    return update_linear(state, residual, derivative, m, gate);
}

Innovation update_twist(MotionState& state, const Measurement& m, const NisGate& gate)
{
    Rows derivative = Rows::Zero(3, kMotionSize);
    derivative(0, kForward) = derivative(1, kLeft) = derivative(2, kTurn) = 1;
    const Eigen::Vector3d residual = m.value - state.mean.segment<3>(kForward);
    return update_linear(state, residual, derivative, m, gate);
}

Innovation update_pose(MotionState& state, const Measurement& m, const NisGate& gate)
{
    Rows derivative = Rows::Zero(3, kMotionSize);
    derivative.leftCols<3>().setIdentity();
    Eigen::Vector3d residual = m.value - state.mean.head<3>();
    residual[kYaw] = wrap_angle(residual[kYaw]);
    return update_linear(state, residual, derivative, m, gate);
}

/// From here on odometry tells its way.
void remember_odometry_pose(MotionState& state)
{
    state.mean.segment<3>(kOdomX) = state.mean.head<3>();
    state.covariance.middleRows<3>(kOdomX) = state.covariance.topRows<3>().eval();
    state.covariance.middleCols<3>(kOdomX) = state.covariance.leftCols<3>().eval();
    state.has_odometry_pose = true;
}

Innovation update_way(MotionState& state, const Measurement& m, const NisGate& gate)
{
    const double c = std::cos(state.mean[kOdomYaw]), s = std::sin(state.mean[kOdomYaw]);
    const double dx = state.mean[kX] - state.mean[kOdomX];
    const double dy = state.mean[kY] - state.mean[kOdomY];
    const double ahead = c * dx + s * dy, aside = c * dy - s * dx;
    Rows derivative = Rows::Zero(3, kMotionSize);
    derivative.topLeftCorner<2, 2>() << c, s, -s, c;
    derivative.block<2, 2>(0, kOdomX) << -c, -s, s, -c;
    derivative(0, kOdomYaw) = aside;
    derivative(1, kOdomYaw) = -ahead;
    derivative(2, kYaw) = 1;
    derivative(2, kOdomYaw) = -1;
    const Eigen::Vector3d residual(
        m.value[0] - ahead, m.value[1] - aside,
        wrap_angle(m.value[2] - (state.mean[kYaw] - state.mean[kOdomYaw])));
    const auto innovation = update_linear(state, residual, derivative, m, gate);
    remember_odometry_pose(state);  // after a slip, too: the next way starts here
    return innovation;
}

/// Velocity and bias stay, but are no longer sure: they led to a pose that was wrong.
void place(MotionState& state, const Measurement& m)
{
    constexpr double speed_mps = 1, turn_radps = 1, bias_radps = 0.02;  // one sigma, added
    const double yaw_by = wrap_angle(m.value[2] - state.mean[kYaw]);
    state.mean.head<2>() = m.value.head<2>();
    state.mean[kYaw] += yaw_by;
    state.covariance.topRows<3>().setZero();
    state.covariance.leftCols<3>().setZero();
    state.covariance.topLeftCorner<3, 3>() = m.covariance;
    state.covariance(kForward, kForward) += speed_mps * speed_mps;
    state.covariance(kLeft, kLeft) += speed_mps * speed_mps;
    state.covariance(kTurn, kTurn) += turn_radps * turn_radps;
    state.covariance(kGyroBias, kGyroBias) += bias_radps * bias_radps;
    state.has_odometry_pose = false;
}
}  // namespace

NisGate::NisGate(double chance)
{
    for (int freedom = 1; freedom <= 3; ++freedom)
    {
        double below = 0, above = 1000;  // at 1000 no chance is left that a double can hold
        for (int halving = 0; halving < 60; ++halving)
        {
            const double middle = 0.5 * (below + above);
            (chance_of_more(middle, freedom) > chance ? below : above) = middle;
        }
        limit[static_cast<std::size_t>(freedom)] = above;
    }
}

bool is_finite(const Measurement& measurement)
{
    return std::isfinite(measurement.time_s) && measurement.value.allFinite();
}

bool has_positive_covariance(const Measurement& measurement)
{
    const int n = freedom_of(measurement.kind);
    using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
    const Block block = measurement.covariance.topLeftCorner(n, n);
    if (!block.allFinite()) return false;
    const Eigen::LLT<Block> root(block);
    return n == 0 || root.info() == Eigen::Success;
}

Innovation update(MotionState& state, const Measurement& m, const NisGate& gate)
{
    switch (m.kind)
    {
        case Kind::YawRate:
            return update_yaw_rate(state, m, gate);
        case Kind::Velocity:
            return update_velocity(state, m, gate);
        case Kind::Twist:
            return update_twist(state, m, gate);
        case Kind::Pose:
            return update_pose(state, m, gate);
        case Kind::Way:
            if (state.has_odometry_pose) return update_way(state, m, gate);
            break;
        case Kind::WayBegin:
            break;
        case Kind::Place:
            place(state, m);
            return {};
    }
    remember_odometry_pose(state);
    return {};
}
}  // namespace rtob

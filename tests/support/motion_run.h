// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/fusion/motion_filter.h>
#include <rtob/sim/noise.h>
#include <Eigen/Cholesky>

#include <cmath>
#include <functional>
#include <vector>

namespace rtob::test
{
/// A vehicle that moves just as the filter's model says, and sensors with just the noise that the
/// filter is told: if the filter is right, its errors are as large as it says.
struct MotionRunOptions
{
    double duration_s = 20;
    bool gyro = true, flow = true, odometry = true;
    double gyro_hz = 50, flow_hz = 20, odometry_hz = 10, scan_hz = 5;
    double gyro_sigma = 0.01, flow_sigma = 0.1, way_sigma_m = 0.01, way_sigma_rad = 0.01;
    double scan_sigma_m = 0.02, scan_sigma_rad = 0.01;
};

inline FusionOptions run_options()
{
    FusionOptions options;
    options.speed_change_mps = 0.5;
    options.turn_change_degps = 30;
    options.gyro_drift_degps = 0.1;
    options.gate_chance = 1e-9;  // a gate cuts the tails of what is measured here
    return options;
}

class MotionRun
{
 public:
    static constexpr double kStep_s = 0.01;
    static constexpr double kRad = 3.14159265358979323846 / 180;

    MotionRun(const MotionRunOptions& options, std::uint64_t seed)
        : options_(options), noise_(seed, 1), sensor_noise_(seed, 2)
    {
        truth_[kForward] = noise_.gaussian(1);
        truth_[kLeft] = noise_.gaussian(1);
        truth_[kTurn] = noise_.gaussian(1);
        truth_[kGyroBias] = noise_.gaussian(run_options().gyro_bias_degps * kRad);
    }

    [[nodiscard]] double time_s() const { return static_cast<double>(steps_) * kStep_s; }
    [[nodiscard]] const MotionVector& truth() const { return truth_; }
    [[nodiscard]] Pose2 pose() const { return {truth_[kX], truth_[kY], truth_[kYaw]}; }

    /// Goes on by kStep_s. @return what was measured then, in order of the sensors
    std::vector<Measurement> step()
    {
        move();
        ++steps_;
        std::vector<Measurement> readings;
        using Kind = Measurement::Kind;
        if (options_.gyro && isDue(options_.gyro_hz))
            readings.push_back(reading(
                Kind::YawRate, {truth_[kTurn] + truth_[kGyroBias], 0, 0},
                {options_.gyro_sigma, 1, 1}));
        if (options_.flow && isDue(options_.flow_hz))
            readings.push_back(reading(
                Kind::Velocity, {truth_[kForward], truth_[kLeft], 0},
                {options_.flow_sigma, options_.flow_sigma, 1}));
        if (options_.odometry && isDue(options_.odometry_hz)) readings.push_back(odometry());
        if (isDue(options_.scan_hz))
            readings.push_back(reading(
                Kind::Pose, truth_.head<3>(),
                {options_.scan_sigma_m, options_.scan_sigma_m, options_.scan_sigma_rad}));
        return readings;
    }

 private:
    /// In parts so short that the order of noise and motion does not matter.
    void move()
    {
        constexpr int parts = 5;
        const double dt_s = kStep_s / parts, root = std::sqrt(dt_s);
        const auto options = run_options();
        for (int part = 0; part < parts; ++part)
        {
            truth_[kForward] += noise_.gaussian(options.speed_change_mps * root);
            truth_[kLeft] += noise_.gaussian(options.speed_change_mps * root);
            truth_[kTurn] += noise_.gaussian(options.turn_change_degps * kRad * root);
            truth_[kGyroBias] += noise_.gaussian(options.gyro_drift_degps * kRad * root);
            const double yaw = truth_[kYaw] + 0.5 * dt_s * truth_[kTurn];
            const double c = std::cos(yaw), s = std::sin(yaw);
            truth_[kX] += dt_s * (c * truth_[kForward] - s * truth_[kLeft]);
            truth_[kY] += dt_s * (s * truth_[kForward] + c * truth_[kLeft]);
            truth_[kYaw] += dt_s * truth_[kTurn];
        }
    }

    [[nodiscard]] bool isDue(double rate_hz) const
    {
        return steps_ % static_cast<std::uint64_t>(std::lround(1 / (rate_hz * kStep_s))) == 0;
    }

    Measurement reading(
        Measurement::Kind kind, const Eigen::Vector3d& exact, const Eigen::Vector3d& sigma)
    {
        Measurement measurement{kind, time_s(), exact, Eigen::Matrix3d::Zero()};
        for (int i = 0; i < 3; ++i) measurement.value[i] += sensor_noise_.gaussian(sigma[i]);
        measurement.covariance.diagonal() = sigma.cwiseAbs2();
        return measurement;
    }

    Measurement odometry()
    {
        const Pose2 way = between(at_odometry_, pose());
        auto measurement = reading(
            had_odometry_ ? Measurement::Kind::Way : Measurement::Kind::WayBegin,
            {way.x, way.y, way.yaw},
            {options_.way_sigma_m, options_.way_sigma_m, options_.way_sigma_rad});
        at_odometry_ = pose();
        had_odometry_ = true;
        return measurement;
    }

    MotionRunOptions options_;
    sim::Noise noise_, sensor_noise_;
    MotionVector truth_ = MotionVector::Zero();
    Pose2 at_odometry_;
    bool had_odometry_ = false;
    std::uint64_t steps_ = 0;
};

/// A filter that knows that the run starts at the origin.
inline MotionFilter started_filter(const FusionOptions& options = run_options())
{
    MotionFilter filter(options);
    filter.start(0, {}, Eigen::Matrix3d::Identity() * 1e-8, {1, 1});
    return filter;
}

/// Normalised estimation error squared of the first states: pose, velocity and perhaps the bias.
inline double nees(const MotionState& state, const MotionVector& truth, int states)
{
    const Eigen::VectorXd error = (truth - state.mean).head(states);
    const Eigen::MatrixXd covariance = state.covariance.topLeftCorner(states, states);
    return error.dot(covariance.ldlt().solve(error));
}
}  // namespace rtob::test

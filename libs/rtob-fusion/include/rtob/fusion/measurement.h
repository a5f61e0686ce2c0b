// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/fusion/motion_state.h>
#include <Eigen/Core>

#include <array>
#include <string_view>
#include <utility>

namespace rtob
{
/// What tells of the vehicle's motion.
enum class MotionSensor
{
    Gyro,       ///< yaw rate
    Flow,       ///< velocity over ground, along the vehicle's axes
    Odometry,   ///< the way since its last reading
    Attitude,   ///< roll and pitch: no part of the planar filter, used to level scans
    Altimeter,  ///< height above the floor: the same
    Scans       ///< poses in the map
};

constexpr auto enum_names(MotionSensor)
{
    return std::array<std::pair<MotionSensor, std::string_view>, 6>{
        {{MotionSensor::Gyro, "gyro"},
         {MotionSensor::Flow, "flow"},
         {MotionSensor::Odometry, "odometry"},
         {MotionSensor::Attitude, "attitude"},
         {MotionSensor::Altimeter, "altimeter"},
         {MotionSensor::Scans, "scans"}}};
}

/// One reading, as the filter takes it.
struct Measurement
{
    enum class Kind
    {
        YawRate,   ///< value[0]: rad/s, with the gyro's bias
        Velocity,  ///< value[0], value[1]: forward, left [m/s]
        Twist,     ///< forward, left [m/s], yaw rate [rad/s] without bias, as wheels tell them
        Way,       ///< from the last odometry reading: x, y, yaw as seen from there
        WayBegin,  ///< an odometry reading that has none before it
        Pose,      ///< x, y, yaw in map
        Place      ///< the same, and all that was thought of the pose is void
    };
    Kind kind = Kind::YawRate;
    double time_s = 0;
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of value, as far as it is used
};

/// How well a measurement agreed with what the filter thought.
struct Innovation
{
    double nis = 0;   ///< normalised innovation squared: chi-square distributed
    int freedom = 0;  ///< its degrees of freedom; 0: the measurement had nothing to compare
    bool used = true;
};

/// The largest NIS that is believed, by degrees of freedom.
struct NisGate
{
    /// @param chance that a good measurement is refused; in (0, 1)
    explicit NisGate(double chance);
    std::array<double, 4> limit{};
};

/// Stamp and value; and a covariance that is positive definite as far as it is used.
[[nodiscard]] bool is_finite(const Measurement& measurement);
[[nodiscard]] bool has_positive_covariance(const Measurement& measurement);

/// Kalman update; the state is at the measurement's time already. Beyond the gate it stays as is.
Innovation update(MotionState& state, const Measurement& measurement, const NisGate& gate);
}  // namespace rtob

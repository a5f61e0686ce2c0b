// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/sim/motion_sensors.h>
#include <rtob/sim/shape.h>

#include <utility>

namespace rtob::sim
{
namespace
{
constexpr double gravity_mps2 = 9.81;
constexpr double rad_per_deg = 3.14159265358979323846 / 180;

/// A vector of the map seen along the vehicle's axes.
Point2 turned_back(double x_map, double y_map, double yaw)
{
    const double c = std::cos(yaw), s = std::sin(yaw);
    return {c * x_map + s * y_map, -s * x_map + c * y_map};
}
}  // namespace

void SensorOptions::validate() const
{
    fields(
        *this, [](const char* key, double value, const char*)
        { require(value >= 0 && std::isfinite(value), key, value, ">= 0"); });
}

MotionSensors::MotionSensors(
    const SensorOptions& options, const Pose3& pose_map_vehicle, std::uint64_t seed)
    : options_(options),
      noise_(seed, 2),
      gyro_bias_radps_(noise_.gaussian(options.gyro_bias_dps * rad_per_deg)),
      ax_bias_mps2_(noise_.gaussian(options.accelerometer_bias_mps2)),
      ay_bias_mps2_(noise_.gaussian(options.accelerometer_bias_mps2)),
      odometry_scale_(1 + noise_.gaussian(options.odometry_scale_bias)),
      odometry_turn_bias_radps_(noise_.gaussian(options.odometry_turn_bias_dps * rad_per_deg)),
      flow_scale_(1 + noise_.gaussian(options.flow_scale_bias)),
      imu_{options.imu_rate_hz},
      odometry_{options.odometry_rate_hz},
      flow_{options.flow_rate_hz},
      altimeter_{options.altimeter_rate_hz},
      pose_map_vehicle_(pose_map_vehicle.from_above())
{
    options_.validate();
}

bool MotionSensors::Clock::isDue(double time_s)
{
    constexpr double rounding_s = 1e-9;
    if (rate_hz <= 0 || time_s + rounding_s < static_cast<double>(readings) / rate_hz) return false;
    // A step longer than the sensor's period gives one reading, not several of the same instant.
    readings = static_cast<std::uint64_t>((time_s + rounding_s) * rate_hz) + 1;
    return true;
}

void MotionSensors::observe(double time_s, const VehicleState& state)
{
    moveOdometry(time_s - time_s_, state.pose_map_vehicle.from_above());
    time_s_ = time_s;
    if (imu_.isDue(time_s)) readings_.imu.push_back(readImu(time_s, state));
    if (odometry_.isDue(time_s)) readings_.odometry.push_back({time_s, pose_odom_vehicle_});
    if (flow_.isDue(time_s)) readings_.flow.push_back(readFlow(time_s, state));
    if (altimeter_.isDue(time_s))
        readings_.altimeter.push_back(
            {time_s, state.pose_map_vehicle.z + noise_.gaussian(options_.altimeter_noise_m)});
}

SensorReadings MotionSensors::takeReadings()
{
    return std::exchange(readings_, {});
}

void MotionSensors::moveOdometry(double dt_s, const Pose2& pose_map_vehicle)
{
    Pose2 step = between(pose_map_vehicle_, pose_map_vehicle);
    pose_map_vehicle_ = pose_map_vehicle;
    const double way_m = std::hypot(step.x, step.y);
    const double sigma_m = options_.odometry_noise * std::sqrt(way_m);
    step.x = odometry_scale_ * step.x + noise_.gaussian(sigma_m);
    step.y = odometry_scale_ * step.y + noise_.gaussian(sigma_m);
    step.yaw += odometry_turn_bias_radps_ * dt_s;
    pose_odom_vehicle_ = compose(pose_odom_vehicle_, step);
}

ImuReading MotionSensors::readImu(double time_s, const VehicleState& state)
{
    const auto& pose = state.pose_map_vehicle;
    const Point2 a = turned_back(state.ax_map_mps2, state.ay_map_mps2, pose.yaw);
    const double sigma = options_.accelerometer_noise_mps2;
    const double tilt_sigma_rad = options_.attitude_noise_deg * rad_per_deg;
    ImuReading imu;
    imu.time_s = time_s;
    imu.yaw_rate_radps = state.yaw_rate_radps + gyro_bias_radps_ +
                         noise_.gaussian(options_.gyro_noise_dps * rad_per_deg);
    // To first order in the tilt, which is small.
    const double lift_mps2 = gravity_mps2 + state.az_map_mps2;
    imu.ax_mps2 = a.x - lift_mps2 * std::sin(pose.pitch) + ax_bias_mps2_ + noise_.gaussian(sigma);
    imu.ay_mps2 = a.y + lift_mps2 * std::sin(pose.roll) + ay_bias_mps2_ + noise_.gaussian(sigma);
    imu.az_mps2 = lift_mps2 + noise_.gaussian(sigma);
    imu.roll_rad = pose.roll + noise_.gaussian(tilt_sigma_rad);
    imu.pitch_rad = pose.pitch + noise_.gaussian(tilt_sigma_rad);
    return imu;
}

FlowReading MotionSensors::readFlow(double time_s, const VehicleState& state)
{
    const Point2 v = turned_back(state.vx_map_mps, state.vy_map_mps, state.pose_map_vehicle.yaw);
    const double sigma = options_.flow_noise_mps;
    return {
        time_s, flow_scale_ * v.x + noise_.gaussian(sigma),
        flow_scale_ * v.y + noise_.gaussian(sigma)};
}
}  // namespace rtob::sim

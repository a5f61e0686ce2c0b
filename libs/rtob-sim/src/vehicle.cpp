// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/sim/vehicle.h>

#include <algorithm>

namespace rtob::sim
{
namespace
{
constexpr double gravity_mps2 = 9.81;
constexpr double rad_per_deg = 3.14159265358979323846 / 180;
constexpr double tilt_lag_s = 0.1;  // the attitude loop of a multirotor
constexpr double yaw_gust_time_s = 0.3;

/// The share of a step change that a first-order lag makes good in dt.
double caught_up(double dt_s, double lag_s)
{
    return 1 - std::exp(-dt_s / lag_s);
}

/// Shortens (x, y) to at most this length.
void limit(double& x, double& y, double longest)
{
    const double size = std::hypot(x, y);
    if (size <= longest) return;
    x *= longest / size;
    y *= longest / size;
}
}  // namespace

void VehicleOptions::validate() const
{
    require(radius_m > 0, "radius_m", radius_m, "> 0");
    require(velocity_lag_s > 0, "velocity_lag_s", velocity_lag_s, "> 0");
    require(yaw_lag_s > 0, "yaw_lag_s", yaw_lag_s, "> 0");
    require(climb_lag_s > 0, "climb_lag_s", climb_lag_s, "> 0");
    require(max_speed_mps > 0, "max_speed_mps", max_speed_mps, "> 0");
    require(max_acceleration_mps2 > 0, "max_acceleration_mps2", max_acceleration_mps2, "> 0");
    require(max_yaw_rate_dps > 0, "max_yaw_rate_dps", max_yaw_rate_dps, "> 0");
    require(max_climb_mps >= 0, "max_climb_mps", max_climb_mps, ">= 0");
    require(max_tilt_deg >= 0 && max_tilt_deg <= 30, "max_tilt_deg", max_tilt_deg, "0 to 30");
    require(turbulence_mps2 >= 0, "turbulence_mps2", turbulence_mps2, ">= 0");
    require(turbulence_time_s > 0, "turbulence_time_s", turbulence_time_s, "> 0");
    require(yaw_turbulence_dps2 >= 0, "yaw_turbulence_dps2", yaw_turbulence_dps2, ">= 0");
}

Vehicle::Vehicle(const VehicleOptions& options, const Pose3& pose_map_vehicle, std::uint64_t seed)
    : options_(options),
      noise_(seed, 0),
      gust_x_(options.turbulence_mps2, options.turbulence_time_s),
      gust_y_(options.turbulence_mps2, options.turbulence_time_s),
      gust_yaw_(options.yaw_turbulence_dps2 * rad_per_deg, yaw_gust_time_s)
{
    options_.validate();
    state_.pose_map_vehicle = pose_map_vehicle;
}

void Vehicle::step(double dt_s, const VelocityCommand& command)
{
    stepYaw(dt_s, command);
    stepVelocity(dt_s, command);
    stepHeight(dt_s, command);
}

void Vehicle::stepVelocity(double dt_s, const VelocityCommand& command)
{
    auto& s = state_;
    double forward = command.forward_mps;
    double left = options_.kind == VehicleKind::Multirotor ? command.left_mps : 0;
    limit(forward, left, options_.max_speed_mps);
    const double c = std::cos(s.pose_map_vehicle.yaw), sn = std::sin(s.pose_map_vehicle.yaw);
    if (options_.kind == VehicleKind::Differential)
    {
        // Wheels do not slip sideways: the speed turns with the vehicle.
        const double speed = c * s.vx_map_mps + sn * s.vy_map_mps;
        s.vx_map_mps = c * speed;
        s.vy_map_mps = sn * speed;
    }
    const double share = caught_up(dt_s, options_.velocity_lag_s) / dt_s;
    double ax = share * (c * forward - sn * left - s.vx_map_mps);
    double ay = share * (sn * forward + c * left - s.vy_map_mps);
    limit(ax, ay, options_.max_acceleration_mps2);
    stepTilt(dt_s, ax, ay);
    if (options_.kind == VehicleKind::Multirotor)
    {
        ax += gust_x_.step(dt_s, noise_);
        ay += gust_y_.step(dt_s, noise_);
    }
    s.pose_map_vehicle.x += dt_s * (s.vx_map_mps + 0.5 * dt_s * ax);
    s.pose_map_vehicle.y += dt_s * (s.vy_map_mps + 0.5 * dt_s * ay);
    s.vx_map_mps += dt_s * ax;
    s.vy_map_mps += dt_s * ay;
    s.ax_map_mps2 = ax;
    s.ay_map_mps2 = ay;
}

void Vehicle::stepTilt(double dt_s, double ax_map_mps2, double ay_map_mps2)
{
    if (options_.kind != VehicleKind::Multirotor) return;
    auto& pose = state_.pose_map_vehicle;
    const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
    double pitch = std::atan((c * ax_map_mps2 + s * ay_map_mps2) / gravity_mps2);
    double roll = -std::atan((-s * ax_map_mps2 + c * ay_map_mps2) / gravity_mps2);
    limit(pitch, roll, options_.max_tilt_deg * rad_per_deg);
    const double share = caught_up(dt_s, tilt_lag_s);
    pose.pitch += share * (pitch - pose.pitch);
    pose.roll += share * (roll - pose.roll);
}

void Vehicle::stepYaw(double dt_s, const VelocityCommand& command)
{
    auto& s = state_;
    const double fastest = options_.max_yaw_rate_dps * rad_per_deg;
    const double wished = std::clamp(command.yaw_rate_radps, -fastest, fastest);
    const double before = s.yaw_rate_radps;
    s.yaw_rate_radps += caught_up(dt_s, options_.yaw_lag_s) * (wished - before);
    if (options_.kind == VehicleKind::Multirotor)
        s.yaw_rate_radps += dt_s * gust_yaw_.step(dt_s, noise_);
    auto& yaw = s.pose_map_vehicle.yaw;
    yaw = wrap_angle(yaw + dt_s * 0.5 * (before + s.yaw_rate_radps));
}

void Vehicle::stepHeight(double dt_s, const VelocityCommand& command)
{
    if (options_.kind != VehicleKind::Multirotor) return;
    auto& s = state_;
    const double wished =
        std::clamp(command.climb_mps, -options_.max_climb_mps, options_.max_climb_mps);
    const double before = s.climb_mps;
    s.climb_mps += caught_up(dt_s, options_.climb_lag_s) * (wished - before);
    s.az_map_mps2 = (s.climb_mps - before) / dt_s;
    s.pose_map_vehicle.z += dt_s * 0.5 * (before + s.climb_mps);
}
}  // namespace rtob::sim

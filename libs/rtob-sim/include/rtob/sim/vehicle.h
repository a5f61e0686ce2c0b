// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/sim/noise.h>
#include <rtob/sim/pose3.h>

#include <array>
#include <string_view>
#include <utility>

namespace rtob::sim
{
enum class VehicleKind
{
    Multirotor,
    Differential
};

constexpr auto enum_names(VehicleKind)
{
    return std::array<std::pair<VehicleKind, std::string_view>, 2>{
        {{VehicleKind::Multirotor, "multirotor"}, {VehicleKind::Differential, "differential"}}};
}

struct VehicleOptions
{
    VehicleKind kind = VehicleKind::Multirotor;
    double radius_m = 0.45;  ///< half of the paper's span
    double velocity_lag_s = 0.4;
    double yaw_lag_s = 0.2;
    double climb_lag_s = 0.6;
    double max_speed_mps = 3;
    double max_acceleration_mps2 = 0.85;  ///< what a tilt of 5 degrees gives
    double max_yaw_rate_dps = 120;
    double max_climb_mps = 1;
    double max_tilt_deg = 5;
    double turbulence_mps2 = 0;  ///< RMS of the gusts, each axis of the plane
    double turbulence_time_s = 0.5;
    double yaw_turbulence_dps2 = 0;  ///< RMS

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("radius_m", s.radius_m, "of the circle that holds the vehicle; > 0");
        visit("velocity_lag_s", s.velocity_lag_s, "until 63 % of a new velocity is there; > 0");
        visit("yaw_lag_s", s.yaw_lag_s, "the same for the yaw rate; > 0");
        visit("climb_lag_s", s.climb_lag_s, "the same for the climb rate; > 0");
        visit("max_speed_mps", s.max_speed_mps, "> 0");
        visit("max_acceleration_mps2", s.max_acceleration_mps2, "> 0");
        visit("max_yaw_rate_dps", s.max_yaw_rate_dps, "> 0");
        visit("max_climb_mps", s.max_climb_mps, ">= 0");
        visit("max_tilt_deg", s.max_tilt_deg, "it tilts as it accelerates, but no more; 0 to 30");
        visit("turbulence_mps2", s.turbulence_mps2, "RMS of the gusts; >= 0");
        visit("turbulence_time_s", s.turbulence_time_s, "for which a gust lasts; > 0");
        visit("yaw_turbulence_dps2", s.yaw_turbulence_dps2, "RMS of gusts that turn it; >= 0");
    }
    /// Throws std::invalid_argument naming key, value and range.
    void validate() const;
};

/// The truth about the vehicle.
struct VehicleState
{
    Pose3 pose_map_vehicle;
    double vx_map_mps = 0, vy_map_mps = 0, climb_mps = 0;
    double yaw_rate_radps = 0;
    double ax_map_mps2 = 0, ay_map_mps2 = 0, az_map_mps2 = 0;  ///< over the last step
};

/// What pilot, guard or script want: velocities along the vehicle's own axes.
struct VelocityCommand
{
    double forward_mps = 0;
    double left_mps = 0;  ///< a differential drive cannot follow it
    double yaw_rate_radps = 0;
    double climb_mps = 0;
};

/// A vehicle that follows velocity commands as a first-order lag, with bounded acceleration.
class Vehicle
{
 public:
    Vehicle(const VehicleOptions& options, const Pose3& pose_map_vehicle, std::uint64_t seed);

    void step(double dt_s, const VelocityCommand& command);
    [[nodiscard]] const VehicleState& state() const { return state_; }
    [[nodiscard]] const VehicleOptions& options() const { return options_; }

 private:
    void stepVelocity(double dt_s, const VelocityCommand& command);
    void stepTilt(double dt_s, double ax_map_mps2, double ay_map_mps2);
    void stepYaw(double dt_s, const VelocityCommand& command);
    void stepHeight(double dt_s, const VelocityCommand& command);

    VehicleOptions options_;
    VehicleState state_;
    Noise noise_;
    Wander gust_x_, gust_y_, gust_yaw_;
};
}  // namespace rtob::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/sim/vehicle.h>

#include <vector>

namespace rtob::sim
{
/// Everything that tells of motion beside the laser. A rate of 0 leaves a sensor out. "bias" is the
/// standard deviation of an error that is drawn once and stays.
struct SensorOptions
{
    double imu_rate_hz = 100;
    double gyro_noise_dps = 0.2, gyro_bias_dps = 0.5;
    double accelerometer_noise_mps2 = 0.2, accelerometer_bias_mps2 = 0.1;
    double attitude_noise_deg = 0.3;
    double odometry_rate_hz = 20;
    double odometry_noise = 0.02, odometry_scale_bias = 0.02, odometry_turn_bias_dps = 0.3;
    double flow_rate_hz = 20;
    double flow_noise_mps = 0.05, flow_scale_bias = 0.03;
    double altimeter_rate_hz = 20;
    double altimeter_noise_m = 0.02;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("imu_rate_hz", s.imu_rate_hz, "gyroscope, accelerometer, attitude; 0: none");
        visit("gyro_noise_dps", s.gyro_noise_dps, "of a reading; >= 0");
        visit("gyro_bias_dps", s.gyro_bias_dps, ">= 0");
        visit("accelerometer_noise_mps2", s.accelerometer_noise_mps2, "of a reading; >= 0");
        visit("accelerometer_bias_mps2", s.accelerometer_bias_mps2, ">= 0");
        visit("attitude_noise_deg", s.attitude_noise_deg, "of roll and pitch; >= 0");
        visit("odometry_rate_hz", s.odometry_rate_hz, "0: none");
        visit("odometry_noise", s.odometry_noise, "m after 1 m, grows as its root; >= 0");
        visit("odometry_scale_bias", s.odometry_scale_bias, "share of the way; >= 0");
        visit("odometry_turn_bias_dps", s.odometry_turn_bias_dps, ">= 0");
        visit("flow_rate_hz", s.flow_rate_hz, "optical flow: velocity over ground; 0: none");
        visit("flow_noise_mps", s.flow_noise_mps, "of a reading; >= 0");
        visit("flow_scale_bias", s.flow_scale_bias, "share of the velocity; >= 0");
        visit("altimeter_rate_hz", s.altimeter_rate_hz, "0: none");
        visit("altimeter_noise_m", s.altimeter_noise_m, "of a reading; >= 0");
    }
    /// Throws std::invalid_argument naming key, value and range.
    void validate() const;
};

/// In the vehicle's axes: x ahead, y to the left, z up.
struct ImuReading
{
    double time_s = 0;
    double yaw_rate_radps = 0;
    double ax_mps2 = 0, ay_mps2 = 0, az_mps2 = 0;  ///< specific force: at rest az is +9.81
    double roll_rad = 0, pitch_rad = 0;
};

struct OdometryReading
{
    double time_s = 0;
    Pose2 pose_odom_vehicle;
};

/// Over ground, along the vehicle's axes.
struct FlowReading
{
    double time_s = 0;
    double forward_mps = 0, left_mps = 0;
};

struct AltimeterReading
{
    double time_s = 0;
    double height_m = 0;
};

struct SensorReadings
{
    std::vector<ImuReading> imu;
    std::vector<OdometryReading> odometry;
    std::vector<FlowReading> flow;
    std::vector<AltimeterReading> altimeter;
};

class MotionSensors
{
 public:
    MotionSensors(const SensorOptions& options, const Pose3& pose_map_vehicle, std::uint64_t seed);

    /// The vehicle went on to this state, held at this time.
    void observe(double time_s, const VehicleState& state);
    /// What was read since the last call.
    [[nodiscard]] SensorReadings takeReadings();

 private:
    /// Tells when the next reading of a sensor is due.
    struct Clock
    {
        double rate_hz = 0;
        std::uint64_t readings = 0;
        [[nodiscard]] bool isDue(double time_s);
    };

    void moveOdometry(double dt_s, const Pose2& pose_map_vehicle);
    [[nodiscard]] ImuReading readImu(double time_s, const VehicleState& state);
    [[nodiscard]] FlowReading readFlow(double time_s, const VehicleState& state);

    SensorOptions options_;
    Noise noise_;
    double gyro_bias_radps_, ax_bias_mps2_, ay_bias_mps2_;
    double odometry_scale_, odometry_turn_bias_radps_, flow_scale_;
    Clock imu_, odometry_, flow_, altimeter_;
    double time_s_ = 0;
    Pose2 pose_map_vehicle_, pose_odom_vehicle_;
    SensorReadings readings_;
};
}  // namespace rtob::sim

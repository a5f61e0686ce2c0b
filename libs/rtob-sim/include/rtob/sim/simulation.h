// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/sim/laser.h>
#include <rtob/sim/motion_sensors.h>
#include <rtob/sim/scene.h>
#include <rtob/sim/vehicle.h>

namespace rtob::sim
{
struct SimulationOptions
{
    LaserOptions laser;
    VehicleOptions vehicle;
    SensorOptions sensors;
    Pose3 start_map{0, 0, 1, 0, 0, 0};  ///< the vehicle's first pose
    std::uint64_t seed = 1;
};

/// A vehicle with its laser and sensors in a world, driven step by step:
///
///     Simulation simulation(world, options);
///     while (simulation.time_s() < 60)
///     {
///         simulation.step(0.02, command);
///         if (const auto scan = simulation.takeScan()) command = decide(*scan);
///         if (simulation.clearance_m() < radius_m) ++contacts;
///     }
///
/// Time starts at 0. Same world, options, steps and commands: the same numbers.
class Simulation
{
 public:
    /// Throws std::invalid_argument for options out of range and for a start inside a wall.
    Simulation(World world, const SimulationOptions& options);

    /// Goes on by dt > 0, in parts of at most 20 ms. Walls do not stop the vehicle: ask clearance.
    void step(double dt_s, const VelocityCommand& command);

    [[nodiscard]] double time_s() const { return time_s_; }
    [[nodiscard]] const VehicleState& state() const { return vehicle_.state(); }

    /// The newest finished turn of the laser, once; to be asked at least once a turn.
    [[nodiscard]] std::optional<LaserScan> takeScan() { return laser_.takeScan(); }
    /// A whole scan from where the vehicle is now, undistorted.
    [[nodiscard]] LaserScan snapshot();
    [[nodiscard]] SensorReadings takeReadings() { return sensors_.takeReadings(); }

    /// From the vehicle's middle to the nearest thing at its height; 0 inside a solid thing.
    [[nodiscard]] double clearance_m() const;
    [[nodiscard]] const Scene& scene() const { return scene_; }

 private:
    void stepOnce(double dt_s, const VelocityCommand& command);

    Scene scene_;
    Laser laser_;
    Vehicle vehicle_;
    MotionSensors sensors_;
    double time_s_ = 0;
};
}  // namespace rtob::sim

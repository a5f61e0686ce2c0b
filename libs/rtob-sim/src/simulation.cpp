// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/sim/simulation.h>

#include <stdexcept>
#include <string>

namespace rtob::sim
{
namespace
{
constexpr double longest_step_s = 0.02;

std::string refusal(const Pose3& start, double clearance_m, double radius_m)
{
    const auto text = [](double value) { return std::to_string(value); };
    return "the vehicle starts inside a wall: at x = " + text(start.x) +
           " m, y = " + text(start.y) + " m, z = " + text(start.z) + " m the next thing is " +
           text(clearance_m) + " m away, and the vehicle's radius is " + text(radius_m) +
           " m; move its start or make radius_m smaller";
}
}  // namespace

Simulation::Simulation(World world, const SimulationOptions& options)
    : scene_(std::move(world)),
      laser_(options.laser, options.seed),
      vehicle_(options.vehicle, options.start_map, options.seed),
      sensors_(options.sensors, options.start_map, options.seed)
{
    const double room_m = clearance_m();
    if (room_m < options.vehicle.radius_m)
        throw std::invalid_argument(refusal(options.start_map, room_m, options.vehicle.radius_m));
}

void Simulation::step(double dt_s, const VelocityCommand& command)
{
    if (!(dt_s > 0)) throw std::invalid_argument("a step must be longer than 0 s");
    const int parts = static_cast<int>(std::ceil(dt_s / longest_step_s - 1e-9));
    for (int i = 0; i < parts; ++i) stepOnce(dt_s / parts, command);
}

void Simulation::stepOnce(double dt_s, const VelocityCommand& command)
{
    const double from_s = time_s_, to_s = time_s_ + dt_s;
    const Pose3 from_map = vehicle_.state().pose_map_vehicle;
    vehicle_.step(dt_s, command);
    scene_.moveTo(0.5 * (from_s + to_s));
    laser_.sweep(scene_, from_s, from_map, to_s, vehicle_.state().pose_map_vehicle);
    sensors_.observe(to_s, vehicle_.state());
    time_s_ = to_s;
}

LaserScan Simulation::snapshot()
{
    return laser_.snapshot(scene_, time_s_, vehicle_.state().pose_map_vehicle);
}

double Simulation::clearance_m() const
{
    const auto& pose = vehicle_.state().pose_map_vehicle;
    return scene_.clearance_m({pose.x, pose.y}, pose.z);
}
}  // namespace rtob::sim

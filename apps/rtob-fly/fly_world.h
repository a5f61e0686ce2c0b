// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/sim/world.h>
#include <Eigen/Core>

#include <string>
#include <vector>

namespace rtob::fly
{
/// A place to fly in.
struct FlyWorld
{
    std::string name;
    sim::World world;
    Box area;                                ///< where flights may start
    std::vector<Eigen::Vector2d> route_map;  ///< of a scripted pilot
};

[[nodiscard]] std::vector<std::string> fly_world_names();

/// @throws std::invalid_argument that lists the names
[[nodiscard]] FlyWorld make_fly_world(const std::string& name);

/// A wall with one door in it across a large room; the vehicle is to go along +x, through the door.
[[nodiscard]] FlyWorld door_world(double door_width_m, double wall_thickness_m);
}  // namespace rtob::fly

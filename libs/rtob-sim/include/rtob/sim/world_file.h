// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/sim/flight.h>
#include <rtob/sim/simulation.h>

#include <stdexcept>
#include <string>

namespace rtob::sim
{
/// Something is wrong with a world file: what() begins with "file:line: ".
class WorldError : public std::runtime_error
{
 public:
    using std::runtime_error::runtime_error;
};

/// All that a world file tells: the world, and who flies in it how.
struct WorldFile
{
    World world;
    SimulationOptions simulation;
    FlightPlan flight;
    int flight_line = 0, start_line = 0;  ///< where the file says so; 0: it does not
};

/// Reads a world in YAML, as docs/worlds.md explains it; a plan that it names is looked for beside
/// it. Throws WorldError for what it does not know, what contradicts itself or is out of range, and
/// for a vehicle that starts inside a wall.
[[nodiscard]] WorldFile read_world(const std::string& file);
}  // namespace rtob::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/sim/world_file.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace rtob
{
/// One simulated flight into one log.
struct SimulateJob
{
    std::string world, log, truth;  ///< files; truth: TUM
    std::uint64_t seed = 1;
    bool may_overwrite = false;
    bool laser_only = false;  ///< leave all other sensors out of the log
    /// What the world file says otherwise.
    std::optional<double> duration_s, speed_mps, yaw_rate_dps, rate_hz;
};

struct SimulatedLog
{
    std::string world;
    double duration_s = 0;
    std::uint64_t scans = 0;
    double way_m = 0;
    double least_clearance_m = 0;  ///< from the vehicle's middle
    double radius_m = 0;
    double fastest_turn_dps = 0, fastest_mps = 0;
};

/// Where the truth goes unless told otherwise: LOG's name with .truth.tum for .rawlog.
[[nodiscard]] std::string default_truth_file(const std::string& log);

/// Flies the world's flight and writes log and truth; both appear whole or not at all. `progress`
/// is given the share that is done. Throws std::runtime_error naming the file.
SimulatedLog simulate(const SimulateJob& job, const std::function<void(double)>& progress = {});

/// For people: a few lines.
[[nodiscard]] std::string simulation_text(const SimulateJob& job, const SimulatedLog& log);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "simulate/simulate_job.h"

#include <rtob/io/rawlog_writer.h>
#include <rtob/io/scan_timing.h>
#include <rtob/io/tum.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "simulate/simulated_observations.h"

namespace rtob
{
namespace
{
constexpr double step_s = 0.01;  // of the vehicle; beams have times of their own
constexpr double deg_per_rad = 180 / 3.14159265358979323846;

sim::WorldFile world_of(const SimulateJob& job)
{
    auto world = sim::read_world(job.world);
    world.simulation.seed = job.seed;
    auto& flight = world.flight;
    flight.duration_s = job.duration_s.value_or(flight.duration_s);
    flight.speed_mps = job.speed_mps.value_or(flight.speed_mps);
    if (job.yaw_rate_dps)
    {
        flight.heading = sim::Heading::Spin;
        flight.yaw_rate_dps = *job.yaw_rate_dps;
    }
    world.simulation.laser.rate_hz = job.rate_hz.value_or(world.simulation.laser.rate_hz);
    return world;
}

void refuse_to_replace(const std::string& file, const SimulateJob& job)
{
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored) && !job.may_overwrite)
        throw std::runtime_error(file + " exists. Name another file, or add --overwrite.");
}

/// Sensors other than the laser, by time: a scan comes after what was read during its turn.
template <class Readings>
void add_observations(
    const Readings& readings, std::vector<mrpt::obs::CObservation::Ptr>& observations)
{
    for (const auto& reading : readings) observations.push_back(observation_of(reading));
}

void write_readings(const sim::SensorReadings& readings, RawlogWriter& log)
{
    std::vector<mrpt::obs::CObservation::Ptr> observations;
    add_observations(readings.imu, observations);
    add_observations(readings.odometry, observations);
    add_observations(readings.flow, observations);
    add_observations(readings.altimeter, observations);
    std::stable_sort(
        observations.begin(), observations.end(),
        [](const auto& a, const auto& b) { return a->timestamp < b->timestamp; });
    for (const auto& observation : observations) log.write({observation, nullptr});
}

/// Where the stamp is the first beam's, a record before the scan tells how long the sweep took: all
/// that deskewing needs.
void write_scan(const sim::LaserScan& scan, const sim::LaserOptions& laser, RawlogWriter& log)
{
    const auto observation = observation_of(scan, laser);
    if (laser.stamp_at == 0)
        log.write({timing_record(*observation, {laser.beams * laser.beam_interval_s()}), nullptr});
    log.write({observation, nullptr});
}

/// What the flight was like, for the text.
void watch(const sim::Simulation& simulation, const Pose2& before, SimulatedLog& result)
{
    const auto& state = simulation.state();
    const Pose2 step = between(before, state.pose_map_vehicle.from_above());
    result.way_m += std::hypot(step.x, step.y);
    result.least_clearance_m = std::min(result.least_clearance_m, simulation.clearance_m());
    result.fastest_turn_dps =
        std::max(result.fastest_turn_dps, deg_per_rad * std::abs(state.yaw_rate_radps));
    result.fastest_mps =
        std::max(result.fastest_mps, std::hypot(state.vx_map_mps, state.vy_map_mps));
}
}  // namespace

std::string default_truth_file(const std::string& log)
{
    const std::filesystem::path path(log);
    const auto stem = path.extension() == ".rawlog" ? path.stem() : path.filename();
    return (path.parent_path() / stem).string() + ".truth.tum";
}

SimulatedLog simulate(const SimulateJob& job, const std::function<void(double)>& progress)
{
    refuse_to_replace(job.log, job);
    refuse_to_replace(job.truth, job);
    const auto world = world_of(job);
    sim::Simulation simulation(world.world, world.simulation);
    const sim::Pilot pilot(world.flight, world.simulation.start_map);
    const auto& vehicle = world.simulation.vehicle;
    SimulatedLog result{world.world.name,         world.flight.duration_s, 0, 0,
                        simulation.clearance_m(), vehicle.radius_m,        0, 0};
    RawlogWriter log(job.log);
    std::vector<StampedPose2> truth;
    const auto steps = static_cast<std::uint64_t>(std::llround(world.flight.duration_s / step_s));
    for (std::uint64_t step = 0; step < steps; ++step)
    {
        const Pose2 before = simulation.state().pose_map_vehicle.from_above();
        simulation.step(
            step_s, pilot.command(simulation.time_s(), simulation.state(), vehicle.kind));
        watch(simulation, before, result);
        const auto scan = simulation.takeScan();
        if (!scan) continue;
        const auto readings = simulation.takeReadings();
        if (!job.laser_only) write_readings(readings, log);
        write_scan(*scan, world.simulation.laser, log);
        truth.push_back({kSimulationEpoch_s + scan->time_s, scan->pose_map_vehicle.from_above()});
        ++result.scans;
        if (progress) progress(static_cast<double>(step) / static_cast<double>(steps));
    }
    log.commit();
    write_tum(job.truth, truth);
    return result;
}

std::string simulation_text(const SimulateJob& job, const SimulatedLog& log)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(1);
    text << log.world << ", seed " << job.seed << ": " << log.duration_s << " s, " << log.scans
         << " scans, " << log.way_m << " m flown, up to " << std::setprecision(2) << log.fastest_mps
         << " m/s and " << std::setprecision(0) << log.fastest_turn_dps << " deg/s\n";
    text << std::setprecision(2);
    if (log.least_clearance_m < log.radius_m)
        text << "It touched something: the vehicle's middle came as near as "
             << log.least_clearance_m << " m, its radius is " << log.radius_m << " m.\n";
    text << "Log " << job.log << "\nTruth " << job.truth << "\n";
    return text.str();
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "endure/endurance.h"

#include <rtob/core/spread.h>
#include <rtob/sim/flight.h>
#include <rtob/sim/simulation.h>
#include <rtob/sim/world_file.h>
#include <rtob/slam/slam.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <utility>
#include <vector>

#include "simulate/simulated_observations.h"

namespace rtob
{
namespace
{
constexpr double kStep_s = 0.01;

double memory_now_mb()
{
    std::ifstream in("/proc/self/statm");
    double all_pages = 0, resident_pages = 0;
    in >> all_pages >> resident_pages;
    return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

class BlockCounter
{
 public:
    explicit BlockCounter(std::uint64_t every_scans) { ms_.reserve(every_scans); }

    void add(const ScanReport& report, const Pose2& truth)
    {
        const Pose2 error = between(truth, report.pose_map_vehicle);
        block_.error_max_m = std::max(block_.error_max_m, std::hypot(error.x, error.y));
        block_.not_tracking += report.state != TrackingState::Tracking;
        ms_.push_back(static_cast<float>(1e3 * report.times.total()));
    }
    [[nodiscard]] EnduranceBlock take(std::uint64_t scans, const RtobMap& map)
    {
        block_.scans = scans;
        block_.map_scans = map.scans().size();
        block_.map_points = map.size();
        block_.memory_mb = memory_now_mb();
        block_.scan_p50_ms = percentile(ms_, 0.5);
        block_.scan_p99_ms = percentile(ms_, 0.99);
        block_.scan_max_ms = percentile(ms_, 1.0);
        ms_.clear();
        return std::exchange(block_, {});
    }

 private:
    EnduranceBlock block_;
    std::vector<float> ms_;
};
}  // namespace

void endure(const EnduranceJob& job, const std::function<void(const EnduranceBlock&)>& done)
{
    auto world = sim::read_world(job.world);
    world.simulation.seed = job.seed;
    sim::Simulation simulation(world.world, world.simulation);
    const sim::Pilot pilot(world.flight, world.simulation.start_map);
    const auto kind = world.simulation.vehicle.kind;
    Slam slam(job.slam);
    BlockCounter counter(job.every_scans);
    Pose2 first;  // of the vehicle in the world: the map's frame
    for (std::uint64_t scans = 0; scans < job.scans;)
    {
        simulation.step(kStep_s, pilot.command(simulation.time_s(), simulation.state(), kind));
        (void)simulation.takeReadings();
        const auto scan = simulation.takeScan();
        if (!scan) continue;
        const Pose2 truth = scan->pose_map_vehicle.from_above();
        if (scans == 0) first = truth;
        const auto& report = slam.process(*observation_of(*scan, world.simulation.laser));
        counter.add(report, between(first, truth));
        if (++scans % job.every_scans == 0) done(counter.take(scans, slam.map()));
    }
}

std::string endurance_header()
{
    return "     scans   hours  map scans  map points  memory MB  p50 ms  p99 ms  max ms"
           "  worst error m  not tracking\n";
}

std::string endurance_line(const EnduranceBlock& block)
{
    constexpr double scans_per_hour = 36'000;  // an RPLidar's
    char text[200];
    std::snprintf(
        text, sizeof text, "%10llu %7.2f %10zu %11zu %10.1f %7.2f %7.2f %7.2f %14.3f %13llu\n",
        static_cast<unsigned long long>(block.scans),
        static_cast<double>(block.scans) / scans_per_hour, block.map_scans, block.map_points,
        block.memory_mb, block.scan_p50_ms, block.scan_p99_ms, block.scan_max_ms, block.error_max_m,
        static_cast<unsigned long long>(block.not_tracking));
    return text;
}
}  // namespace rtob

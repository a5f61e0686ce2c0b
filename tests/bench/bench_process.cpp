// SPDX-License-Identifier: BSD-3-Clause
// The cost of a whole scan, from the observation to the report, does not grow with the map: the
// vehicle circles in one room, so that the revisit density has all of the map near.
#include "instructions.h"
#include "standing_map.h"

#include <benchmark/benchmark.h>
#include <room_mrpt.h>
#include <rtob/slam/slam.h>

#include <optional>
#include <string>
#include <vector>

using namespace rtob;

namespace
{
RtobMap map_of(const test::TestMap& standing)
{
    RtobMap map;
    for (std::size_t scan = 0; scan < standing.scans.size(); ++scan)
    {
        const Pose2 pose = standing.scans.pose(scan);
        const auto first = standing.scans.firstPoint(scan);
        const auto end = standing.scans.firstPoint(scan + 1);
        Points points_map;
        for (auto i = first; i < end; ++i)
            points_map.add(standing.points_map.x[i], standing.points_map.y[i]);
        map.insertScan(
            map.tick(standing.scans.time(scan)), pose,
            test::moved(points_map, inverse(pose)).view());
    }
    return map;
}

/// One for each size, made when it is first asked for and kept until another is: rows of one size
/// stand together.
Slam& slam_in(std::uint64_t points, bool constant_time)
{
    static std::optional<Slam> slam;
    static std::uint64_t made = 0;
    static bool made_constant = false;
    if (made != points || made_constant != constant_time)
    {
        slam.reset();  // before the next is made: the largest takes gigabytes
        SlamOptions options;
        options.density.laser_range_m = 6;
        if (constant_time) options.icp.stop_step_m = 0;
        slam.emplace(options);
        const test::TestMap& standing = bench::standing_map(points);
        slam->continueIn(map_of(standing), standing.scans.pose(standing.scans.size() - 1));
        made = points;
        made_constant = constant_time;
    }
    return *slam;
}

std::vector<mrpt::obs::CObservation2DRangeScan> one_circle(double begin_s)
{
    std::vector<mrpt::obs::CObservation2DRangeScan> scans;
    for (int i = 0; i < 36; ++i)
        scans.push_back(test::scan_observation(
            test::room_4x3(), bench::circle_pose(static_cast<std::size_t>(i)),
            begin_s + (i + 1) / bench::kScanRate_hz, test::mrpt_laser()));
    return scans;
}

void process_scan(benchmark::State& state, std::uint64_t points, bool constant_time)
{
    Slam& slam = slam_in(points, constant_time);
    auto scans = one_circle(slam.map().clock().now());
    // Begin where the circle ends, and warm up.
    slam.reset(bench::circle_pose(35));
    for (const auto& scan : scans) slam.process(scan);
    std::size_t k = 0;
    const bench::InstructionCount count(state);
    for (auto _ : state)
    {
        auto& scan = scans[k++ % scans.size()];
        scan.timestamp += mrpt::Clock::duration(36 * 1000000);  // 3.6 s, in units of 0.1 us
        benchmark::DoNotOptimize(&slam.process(scan));
    }
    if (slam.state() != TrackingState::Tracking) state.SkipWithError("the scans do not track");
}

const bool registered = []
{
    for (const bool constant_time : {false, true})
        for (const std::uint64_t points :
             {10'000ul, 100'000ul, 1'000'000ul, 10'000'000ul, 100'000'000ul})
            benchmark::RegisterBenchmark(
                ((constant_time ? "process_constant_time/" : "process/") + std::to_string(points))
                    .c_str(),
                process_scan, points, constant_time)
                ->Unit(benchmark::kMicrosecond);
    return true;
}();
}  // namespace

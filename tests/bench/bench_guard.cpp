// SPDX-License-Identifier: BSD-3-Clause
// One decision of the guard over 360 beams and 2000 remembered points, beside walls: a wish that is
// safe, one that must be bent and one that is blocked. The scan that comes with every second
// decision is measured on its own.
#include <benchmark/benchmark.h>
#include <guard_world.h>

using namespace rtob;
using namespace rtob::test;

namespace
{
/// A room full of posts, seen; and as much again remembered in a blind quarter.
struct Scene
{
    VelocityGuard guard{VehicleLimits(), options()};
    double time_s = 0;

    static GuardOptions options()
    {
        GuardOptions options;
        options.memory_s = 1e9;
        options.unknown = UnknownPolicy::Allow;
        return options;
    }

    Scene()
    {
        static_cast<void>(guard.decide(time_s, {0, 0}, standing()));
        // Each of these scans is hidden by the next one, which is nearer: all points are kept.
        for (int i = 0; i < 6; ++i) observe(4.5F - 0.5F * static_cast<float>(i));
    }
    void observe(float range_m)
    {
        time_s += 0.1;
        static_cast<void>(guard.decide(time_s, {0, 0}, standing()));
        std::vector<float> ranges_m(360, range_m);
        GuardScan scan;
        scan.stamp_s = time_s;
        scan.step_rad = 2 * M_PI / 360;
        scan.ranges_m = ranges_m.data();
        scan.beams = ranges_m.size();
        guard.observe(scan, known_pose(time_s, {}));
    }
};

void decide(benchmark::State& state, const Eigen::Vector2d& wish)
{
    Scene scene;
    scene.observe(1.5F);  // the sixth of the scans before is at 2 m: 2160 are hidden, 2000 kept
    for (auto _ : state)
        benchmark::DoNotOptimize(scene.guard.decide(scene.time_s, wish, flying(0.3, 0.1)));
    state.counters["remembered"] = static_cast<double>(scene.guard.remembered_map().size);
}

void observe(benchmark::State& state)
{
    Scene scene;
    for (auto _ : state) scene.observe(1.5F);
    state.counters["remembered"] = static_cast<double>(scene.guard.remembered_map().size);
}

BENCHMARK_CAPTURE(decide, as_wished, Eigen::Vector2d(0.3, 0))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(decide, limited, Eigen::Vector2d(1.5, 0))->Unit(benchmark::kMicrosecond);
BENCHMARK(observe)->Unit(benchmark::kMicrosecond);
}  // namespace

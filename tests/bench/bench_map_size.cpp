// SPDX-License-Identifier: BSD-3-Clause
// The cost of a draw, and of a scan's whole matching, does not grow with the map. All rows of one
// size come together, so that each map is made once.
#include "instructions.h"
#include "standing_map.h"

#include <benchmark/benchmark.h>
#include <rtob/core/enum_names.h>
#include <rtob/core/icp.h>

#include <algorithm>
#include <optional>
#include <string>

using namespace rtob;

namespace
{
struct Setting
{
    std::string name;
    DensityOptions density;
    DrawMode mode = DrawMode::Stratified;
    double gate_m = 0;
};

std::vector<Setting> settings()
{
    std::vector<Setting> all;
    for (const auto density :
         {Density::Uniform, Density::Interval, Density::Window, Density::Forgetting,
          Density::Revisit})
    {
        DensityOptions options;
        options.density = density;
        options.laser_range_m = 6;
        if (density == Density::Forgetting) options.forgetting_s = 60;
        all.push_back({std::string(name_of(density)), options});
    }
    Setting revisit = all.back();
    revisit.density.forgetting_s = 60;
    all.push_back({"revisit_x_forgetting", revisit.density});
    revisit = all[all.size() - 2];
    all.push_back({"revisit_x_gate", revisit.density, DrawMode::Stratified, 1.2});
    all.push_back({"revisit_independent", revisit.density, DrawMode::Independent});
    return all;
}

/// What a scan needs, kept from scan to scan as a map keeps it.
struct Matcher
{
    explicit Matcher(const Setting& setting)
        : gate_m(setting.gate_m), density(setting.density), draw({3600, setting.mode})
    {
    }
    void drawFrom(const test::TestMap& map)
    {
        const Moment now = bench::now_of(map);
        std::optional<Box> gate;
        if (gate_m > 0) gate = Box::around(now.x, now.y, gate_m);
        draw.draw(map.view(), density, now, gate, random, reference);
    }

    double gate_m;
    TimeDensity density;
    ReferenceDraw draw;
    Random random{1};
    Reference reference;
    Icp icp{test::paper_icp_options()};
};

void draw_points(benchmark::State& state, const Setting& setting, std::uint64_t points)
{
    const auto& map = bench::standing_map(points);
    Matcher matcher(setting);
    matcher.drawFrom(map);
    const bench::InstructionCount count(state);
    for (auto _ : state)
    {
        matcher.drawFrom(map);
        benchmark::DoNotOptimize(matcher.reference.indices.data());
    }
}

void match_scan(benchmark::State& state, const Setting& setting, std::uint64_t points)
{
    const auto& map = bench::standing_map(points);
    const Moment now = bench::now_of(map);
    const Points scan = test::moved(
        test::room_4x3().scan_vehicle({now.x - 0.05, now.y + 0.05, 0.03}), {0, 0, 0.05});
    Matcher matcher(setting);
    matcher.drawFrom(map);
    (void)matcher.icp.align(scan.view(), matcher.reference.points.view());
    const bench::InstructionCount count(state);
    for (auto _ : state)
    {
        matcher.drawFrom(map);
        benchmark::DoNotOptimize(matcher.icp.align(scan.view(), matcher.reference.points.view()));
    }
}

const bool registered = []
{
    for (const std::uint64_t points :
         {10'000ul, 100'000ul, 1'000'000ul, 10'000'000ul, 100'000'000ul})
        for (const Setting& setting : settings())
        {
            const std::string row = setting.name + "/" + std::to_string(points);
            benchmark::RegisterBenchmark(("draw/" + row).c_str(), draw_points, setting, points)
                ->Unit(benchmark::kMicrosecond);
            benchmark::RegisterBenchmark(
                ("draw_and_match/" + row).c_str(), match_scan, setting, points)
                ->Unit(benchmark::kMicrosecond);
        }
    return true;
}();
}  // namespace

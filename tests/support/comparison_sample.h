// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/eval/comparison.h>

#include <string>
#include <vector>

/// Comparisons without any program run.
namespace rtob::test
{
/// A run along the x axis, 0.1 m and 1 s a scan, whose scans took these times.
[[nodiscard]] inline ComparedRun run_of(const std::vector<float>& times_ms)
{
    ComparedRun run;
    run.scan_cpu_ms = run.scan_wall_ms = times_ms;
    for (std::size_t i = 0; i < times_ms.size(); ++i)
    {
        const auto k = static_cast<double>(i);
        run.trajectory.push_back({1000 + k, {0.1 * k, 0, 0}});
    }
    run.peak_memory_mb = 64;
    run.map_size = 1234567;
    run.map_unit = "points";
    return run;
}

[[nodiscard]] inline ComparedRun run_with_error(double mean_m)
{
    ComparedRun run = run_of({1, 2, 3});
    run.accuracy = Accuracy{{mean_m, 0.01}, {1.5, 0.5}, {{1001, mean_m}, {1002, mean_m}}};
    return run;
}

[[nodiscard]] inline ComparedRun failed_run(const std::string& reason)
{
    ComparedRun run;
    run.failure = reason;
    return run;
}

/// Two variants with results and one that failed, judged by relations.
[[nodiscard]] inline Comparison comparison_sample()
{
    Comparison comparison;
    comparison.log = "logs/house.rawlog";
    comparison.truth = "house.relations";
    comparison.truth_kind = TruthKind::Relations;
    comparison.scans = 3;
    comparison.duration_s = 2;
    comparison.command = "rtob-slam compare logs/house.rawlog";
    comparison.variants.resize(3);
    comparison.variants[0].name = "good";
    comparison.variants[0].uses_seed = true;
    comparison.variants[0].runs = {run_with_error(0.25), run_with_error(0.5)};
    comparison.variants[0].runs[1].seed = 2;
    comparison.variants[1].name = "poor";
    comparison.variants[1].runs = {run_with_error(4)};
    comparison.variants[1].runs[0].lost_scans = 7;
    comparison.variants[2].name = "broken";
    comparison.variants[2].runs = {failed_run("a file <x.ini> is \"missing\", so | it ends")};
    return comparison;
}
}  // namespace rtob::test

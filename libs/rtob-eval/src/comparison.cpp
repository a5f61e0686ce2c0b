// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/comparison.h>

#include <algorithm>
#include <numeric>

namespace rtob
{
namespace
{
using Runs = std::vector<const ComparedRun*>;

template <class Figure>
Spread over(const Runs& runs, Figure&& figure)
{
    std::vector<double> values;
    for (const auto* run : runs) values.push_back(figure(*run));
    return spread_of(std::move(values));
}

double mean(const std::vector<float>& values, std::size_t begin, std::size_t end)
{
    if (begin >= end) return 0;
    const auto first = values.begin();
    const double sum = std::accumulate(
        first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end), 0.0);
    return sum / static_cast<double>(end - begin);
}

std::size_t a_tenth(const std::vector<float>& values)
{
    return std::min(values.size(), std::max<std::size_t>(1, values.size() / 10));
}

void add_times(const Runs& runs, VariantFigures& figures)
{
    const auto share = [&](double part)
    { return over(runs, [part](const auto& run) { return percentile(run.scan_cpu_ms, part); }); };
    figures.scan_p50_ms = share(0.50);
    figures.scan_p95_ms = share(0.95);
    figures.scan_p99_ms = share(0.99);
    figures.scan_max_ms = share(1.00);
    figures.wall_p99_ms =
        over(runs, [](const auto& run) { return percentile(run.scan_wall_ms, 0.99); });
    figures.first_tenth_ms = over(
        runs, [](const auto& run) { return mean(run.scan_cpu_ms, 0, a_tenth(run.scan_cpu_ms)); });
    figures.last_tenth_ms = over(
        runs,
        [](const auto& run)
        {
            const std::size_t scans = run.scan_cpu_ms.size();
            return mean(run.scan_cpu_ms, scans - a_tenth(run.scan_cpu_ms), scans);
        });
    figures.cpu_s = over(
        runs, [](const auto& run)
        { return std::accumulate(run.scan_cpu_ms.begin(), run.scan_cpu_ms.end(), 0.0) / 1e3; });
}

void add_accuracy(const Runs& runs, VariantFigures& figures)
{
    Runs known;
    for (const auto* run : runs)
        if (run->accuracy) known.push_back(run);
    if (known.empty()) return;
    figures.distance_m = over(known, [](const auto& run) { return run.accuracy->distance_m.mean; });
    figures.turn_deg = over(known, [](const auto& run) { return run.accuracy->turn_deg.mean; });
    figures.worst = *std::max_element(
        known.begin(), known.end(),
        [](const auto* a, const auto* b)
        { return a->accuracy->distance_m.mean < b->accuracy->distance_m.mean; });
}
}  // namespace

VariantFigures figures_of(const ComparedVariant& variant)
{
    VariantFigures figures;
    Runs runs;
    for (const auto& run : variant.runs)
    {
        if (!run.failed())
            runs.push_back(&run);
        else if (figures.failures++ == 0)
            figures.failure = run.failure;
    }
    figures.results = runs.size();
    if (runs.empty()) return figures;
    figures.worst = runs.front();
    add_times(runs, figures);
    add_accuracy(runs, figures);
    figures.peak_memory_mb = over(runs, [](const auto& run) { return run.peak_memory_mb; });
    for (const auto* run : runs)
        if (run->lost_scans)
            figures.lost_scans = std::max(figures.lost_scans.value_or(0), *run->lost_scans);
    figures.map_size =
        over(runs, [](const auto& run) { return static_cast<double>(run.map_size); });
    return figures;
}
}  // namespace rtob

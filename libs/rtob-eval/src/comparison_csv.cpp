// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/comparison_report.h>

#include <sstream>

namespace rtob
{
namespace
{
constexpr const char* header =
    "variant,round,seed,scans,lost_scans,error_mean_m,error_std_m,turn_error_mean_deg,turn_error_"
    "std_deg,"
    "scan_cpu_p50_ms,scan_cpu_p95_ms,scan_cpu_p99_ms,scan_cpu_max_ms,scan_wall_p50_ms,"
    "scan_wall_p99_ms,scan_wall_max_ms,first_tenth_ms,last_tenth_ms,cpu_s,peak_memory_mb,map_size,"
    "map_unit,failure\n";
constexpr int figure_columns = 19;  // from `scans` to `map_unit`

std::string quoted(const std::string& text)
{
    std::string quoted = "\"";
    for (const char letter : text)
        if (letter == '"')
            quoted += "\"\"";
        else
            quoted += letter == '\n' ? ' ' : letter;
    return quoted + "\"";
}

void write_accuracy(std::ostream& out, const std::optional<Accuracy>& accuracy)
{
    if (accuracy)
        out << ',' << accuracy->distance_m.mean << ',' << accuracy->distance_m.std << ','
            << accuracy->turn_deg.mean << ',' << accuracy->turn_deg.std;
    else
        out << ",,,,";
}

void write_figures(std::ostream& out, const ComparedVariant& variant, const ComparedRun& run)
{
    ComparedVariant alone = variant;
    alone.runs = {run};
    const VariantFigures figures = figures_of(alone);
    out << ',' << run.scan_cpu_ms.size() << ',';
    if (run.lost_scans) out << *run.lost_scans;
    write_accuracy(out, run.accuracy);
    for (const auto* spread :
         {&figures.scan_p50_ms, &figures.scan_p95_ms, &figures.scan_p99_ms, &figures.scan_max_ms})
        out << ',' << spread->median;
    for (const double share : {0.5, 0.99, 1.0}) out << ',' << percentile(run.scan_wall_ms, share);
    for (const auto* spread : {&figures.first_tenth_ms, &figures.last_tenth_ms, &figures.cpu_s})
        out << ',' << spread->median;
    out << ',' << run.peak_memory_mb << ',' << run.map_size << ',' << run.map_unit;
}
}  // namespace

std::string comparison_csv(const Comparison& comparison)
{
    std::ostringstream out;
    out.precision(9);
    out << header;
    for (const auto& variant : comparison.variants)
        for (const auto& run : variant.runs)
        {
            out << variant.name << ',' << run.round << ',';
            if (variant.uses_seed) out << run.seed;
            if (run.failed())
                out << std::string(figure_columns, ',') << ',' << quoted(run.failure);
            else
            {
                write_figures(out, variant, run);
                out << ',';
            }
            out << '\n';
        }
    return out.str();
}
}  // namespace rtob

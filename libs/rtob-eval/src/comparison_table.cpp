// SPDX-License-Identifier: BSD-3-Clause
#include "comparison_table.h"

#include <algorithm>
#include <cmath>

#include "plot_axis.h"

namespace rtob
{
namespace
{
/// 1234567 as "1 234 567", smaller numbers with three digits that mean something.
std::string readable(double value)
{
    if (std::abs(value) < 9999.5) return short_number(value);
    std::string text = std::to_string(std::llround(value));
    for (auto i = static_cast<std::ptrdiff_t>(text.size()) - 3; i > 0; i -= 3)
        text.insert(static_cast<std::size_t>(i), " ");
    return text;
}

TableCell cell(const Spread& spread)
{
    TableCell cell{readable(spread.median), {}};
    const std::string lowest = readable(spread.lowest), highest = readable(spread.highest);
    if (lowest != highest) cell.spread = lowest + " – " + highest;
    return cell;
}

TableCell worst_cell(const VariantFigures& figures)
{
    const auto& accuracy = figures.worst->accuracy;
    if (!accuracy) return {"–", {}};
    return {readable(accuracy->distance_m.mean), "± " + readable(accuracy->distance_m.std)};
}

std::vector<TableColumn> columns_for(const Comparison& comparison)
{
    std::vector<TableColumn> columns;
    if (comparison.truth_kind != TruthKind::None)
        columns = {
            {"error, worst run", "m",
             "Mean position error of the variant's worst run, under it the standard deviation. "
             "Smaller is better."},
            {"error, median run", "m",
             "The same of its middle run, under it the best and the worst run."},
            {"turn error", "deg", "Mean error of the direction, in the middle run."}};
    const std::vector<TableColumn> cost{
        {"time per scan, p50", "ms",
         "Half of the scans took at most this much processor time. Under each figure: the lowest "
         "and the highest of the repeated runs."},
        {"p95", "ms", "95 of 100 scans took at most this much."},
        {"p99", "ms", "99 of 100 scans took at most this much."},
        {"max", "ms", "The slowest scan."},
        {"first tenth", "ms", "Mean over the first tenth of the scans, when the map is small."},
        {"last tenth", "ms",
         "Mean over the last tenth. More than the first tenth: the cost grows with the map."},
        {"all scans", "s", "Processor time of the whole log."},
        {"memory", "MB", "The most memory that the program held, its code included."},
        {"map", "points or cells", "What the variant's own map consists of at the end."}};
    columns.insert(columns.end(), cost.begin(), cost.end());
    return columns;
}

TableRow row_of(const ComparedVariant& variant, TruthKind truth)
{
    const VariantFigures figures = figures_of(variant);
    TableRow row{variant.name, {}, figures.failure};
    if (figures.results == 0) return row;
    if (figures.failures > 0)
        row.failure = std::to_string(figures.failures) + " of " +
                      std::to_string(variant.runs.size()) + " runs failed: " + figures.failure;
    if (truth != TruthKind::None)
        row.cells = {worst_cell(figures), cell(figures.distance_m), cell(figures.turn_deg)};
    for (const auto* spread :
         {&figures.scan_p50_ms, &figures.scan_p95_ms, &figures.scan_p99_ms, &figures.scan_max_ms,
          &figures.first_tenth_ms, &figures.last_tenth_ms, &figures.cpu_s, &figures.peak_memory_mb})
        row.cells.push_back(variant.is_reference ? TableCell{"–", {}} : cell(*spread));
    TableCell map = cell(figures.map_size);
    if (figures.map_size.highest > 0) map.figure += " " + figures.worst->map_unit;
    row.cells.push_back(figures.map_size.highest > 0 ? map : TableCell{"–", {}});
    return row;
}

struct Ranked
{
    std::string name;
    double figure = 0;
};

/// "a (0.1 m), then b (0.2 m), c (3 m)": the smallest first.
std::string ranking(std::vector<Ranked> ranked, const std::string& unit)
{
    std::stable_sort(
        ranked.begin(), ranked.end(),
        [](const auto& a, const auto& b) { return a.figure < b.figure; });
    std::string text;
    for (const auto& [name, figure] : ranked)
        text += (text.empty() ? "" : ", ") + name + " (" + readable(figure) + " " + unit + ")";
    return text;
}

/// "rtob-revisit 0.2 to 0.2 ms, ..."
std::string growth(const Comparison& comparison)
{
    std::string text;
    for (const auto& variant : comparison.variants)
    {
        const VariantFigures figures = figures_of(variant);
        if (figures.results == 0 || variant.is_reference) continue;
        text += (text.empty() ? "" : ", ") + variant.name + " " +
                readable(figures.first_tenth_ms.median) + " → " +
                readable(figures.last_tenth_ms.median) + " ms";
    }
    return text;
}
}  // namespace

ComparisonTable comparison_table(const Comparison& comparison)
{
    ComparisonTable table;
    table.columns = columns_for(comparison);
    for (const auto& variant : comparison.variants)
        table.rows.push_back(row_of(variant, comparison.truth_kind));
    return table;
}

std::vector<std::string> comparison_findings(const Comparison& comparison)
{
    std::vector<Ranked> errors, costs;
    std::string failed;
    for (const auto& variant : comparison.variants)
    {
        const VariantFigures figures = figures_of(variant);
        if (figures.failures > 0) failed += (failed.empty() ? "" : ", ") + variant.name;
        if (figures.results == 0) continue;
        if (figures.worst->accuracy)
            errors.push_back({variant.name, figures.worst->accuracy->distance_m.mean});
        if (!variant.is_reference) costs.push_back({variant.name, figures.cpu_s.median});
    }
    std::vector<std::string> findings;
    if (!errors.empty())
        findings.push_back("Most accurate first, by the worst run: " + ranking(errors, "m") + ".");
    if (!costs.empty())
    {
        findings.push_back(
            "Least processor time for the whole log first: " + ranking(costs, "s") + ".");
        findings.push_back(
            "How the mean time of a scan changed from the first tenth of the log to the last (a "
            "time "
            "that grows with the map will some day be too long): " +
            growth(comparison) + ".");
    }
    if (!failed.empty()) findings.push_back("Failed: " + failed + "; the table says why.");
    return findings;
}

std::string comparison_title(const Comparison& comparison)
{
    return "SLAM programs compared on " + comparison.log.substr(comparison.log.rfind('/') + 1);
}

std::string comparison_summary(const Comparison& comparison)
{
    std::size_t runs = 0;
    for (const auto& variant : comparison.variants) runs += variant.runs.size();
    return "SLAM works out, from what a laser sees, where a vehicle is, and draws a map on the "
           "way. Here a vehicle drove for " +
           readable(comparison.duration_s) + " s and recorded " +
           readable(static_cast<double>(comparison.scans)) +
           " laser scans. Each program below had to say where the vehicle was at each scan, from "
           "the "
           "same scans" +
           (comparison.has_odometry ? " and the same odometry (what the wheels report)" : "") +
           ", one after the other on one computer, " + std::to_string(runs) +
           " runs in all, each in a process of its own.";
}

std::string truth_sentence(const Comparison& comparison)
{
    switch (comparison.truth_kind)
    {
        case TruthKind::None:
            return "No truth was given for this log, so nobody knows which path is right. Look at "
                   "the pictures: where a variant put scans wrongly, its walls are doubled or "
                   "blurred.";
        case TruthKind::Relations:
            return "The truth is a list of relations in " + comparison.truth +
                   ": people checked by hand where the vehicle was at one time, seen from another. "
                   "The error is how far a variant's path disagrees with each of them.";
        case TruthKind::Trajectory:
            return "The truth is the trajectory in " + comparison.truth +
                   ". Each variant's path is laid onto it as well as a shift and a turn can; the "
                   "error is the distance that remains at each pose.";
    }
    return {};
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "comparison_table.h"

#include <algorithm>
#include <cmath>

#include "plot_axis.h"

namespace rtob
{
namespace
{
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
        {"scans lost", "at most",
         "Scans at which the program itself said that it did not know where it was. –: it never "
         "says."},
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
    row.cells.push_back(
        {figures.lost_scans ? readable(static_cast<double>(*figures.lost_scans)) : "–", {}});
    TableCell map = cell(figures.map_size);
    if (figures.map_size.highest > 0) map.figure += " " + figures.worst->map_unit;
    row.cells.push_back(figures.map_size.highest > 0 ? map : TableCell{"–", {}});
    return row;
}
}  // namespace

std::string readable(double value)
{
    if (std::abs(value) < 9999.5) return short_number(value);
    std::string text = std::to_string(std::llround(value));
    for (auto i = static_cast<std::ptrdiff_t>(text.size()) - 3; i > 0; i -= 3)
        text.insert(static_cast<std::size_t>(i), " ");
    return text;
}

ComparisonTable comparison_table(const Comparison& comparison)
{
    ComparisonTable table;
    table.columns = columns_for(comparison);
    for (const auto& variant : comparison.variants)
        table.rows.push_back(row_of(variant, comparison.truth_kind));
    return table;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "comparison_plots.h"

#include <rtob/eval/svg_plot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rtob
{
namespace
{
// Slices of the log: as few as make means that do not jump.
constexpr std::size_t slices_of_log = 50;
constexpr double smallest_error_m = 1e-3;  // less is below what any truth can tell

/// A variant with a result, and its run that is drawn.
struct Drawn
{
    const ComparedVariant& variant;
    const ComparedRun& run;
    std::string colour;
};

std::vector<Drawn> drawn_runs(const Comparison& comparison)
{
    std::vector<Drawn> drawn;
    for (std::size_t v = 0; v < comparison.variants.size(); ++v)
        if (const auto figures = figures_of(comparison.variants[v]); figures.worst)
            drawn.push_back({comparison.variants[v], *figures.worst, variant_colour(v)});
    return drawn;
}

/// Values along the log, gathered in slices of equal length.
class Slices
{
 public:
    Slices(double begin, double end, std::size_t count) : begin_(begin), end_(end), slices_(count)
    {
    }

    void add(double place, double value)
    {
        const double share = end_ > begin_ ? (place - begin_) / (end_ - begin_) : 0;
        const auto index = static_cast<std::size_t>(share * static_cast<double>(slices_.size()));
        Slice& slice = slices_[std::min(slices_.size() - 1, index)];
        slice.sum += value;
        slice.highest = std::max(slice.highest, value);
        ++slice.count;
    }

    [[nodiscard]] PlotLine means() const
    {
        return line([](const Slice& slice)
                    { return slice.sum / static_cast<double>(slice.count); });
    }
    [[nodiscard]] PlotLine highest() const
    {
        return line([](const Slice& slice) { return slice.highest; });
    }

 private:
    struct Slice
    {
        double sum = 0, highest = 0;
        std::size_t count = 0;
    };

    /// Through the middles of the slices that hold something; counted from the beginning.
    template <class Value>
    [[nodiscard]] PlotLine line(Value&& value) const
    {
        PlotLine line;
        const double length = (end_ - begin_) / static_cast<double>(slices_.size());
        for (std::size_t i = 0; i < slices_.size(); ++i)
        {
            if (slices_[i].count == 0) continue;
            line.x.push_back(length * (static_cast<double>(i) + 0.5));
            line.y.push_back(value(slices_[i]));
        }
        return line;
    }

    double begin_, end_;
    std::vector<Slice> slices_;
};

PlotLine path_line(const Drawn& drawn)
{
    PlotLine line{drawn.variant.name, drawn.colour, {}, {}};
    for (const auto& stamped : drawn.run.trajectory)
    {
        line.x.push_back(stamped.pose.x);
        line.y.push_back(stamped.pose.y);
    }
    return line;
}

Box box_of(const PlotLine& line)
{
    const auto [low_x, high_x] = std::minmax_element(line.x.begin(), line.x.end());
    const auto [low_y, high_y] = std::minmax_element(line.y.begin(), line.y.end());
    const Box box{*low_x, *low_y, *high_x, *high_y};
    return box.grown(0.5 + 0.15 * std::max(*high_x - *low_x, *high_y - *low_y));
}

/// The run that the others' paths are seen beside: the most accurate one, or else the first.
const Drawn& best_of(const std::vector<Drawn>& drawn)
{
    const auto error = [](const Drawn& d)
    {
        return d.run.accuracy ? d.run.accuracy->distance_m.mean
                              : std::numeric_limits<double>::infinity();
    };
    return *std::min_element(
        drawn.begin(), drawn.end(),
        [&](const auto& a, const auto& b) { return error(a) < error(b); });
}

ComparisonPlot plot_of_paths(const std::vector<Drawn>& drawn)
{
    std::vector<PlotLine> lines;
    for (const auto& d : drawn) lines.push_back(path_line(d));
    PlotLook look;
    look.x_label = "x [m]";
    look.y_label = "y [m]";
    look.same_scale = true;
    look.height_px = 640;
    look.view = box_of(path_line(best_of(drawn)));
    return {
        "paths", "Paths",
        "Where each variant says the vehicle drove, all seen from the first pose. Lines that leave "
        "the picture have lost their way.",
        draw_svg_plot(lines, look)};
}

ComparisonPlot plot_of_errors(const std::vector<Drawn>& drawn)
{
    std::vector<PlotLine> lines;
    for (const auto& d : drawn)
    {
        if (!d.run.accuracy) continue;
        const auto& errors = d.run.accuracy->errors;
        const double begin = errors.front().time_s, end = errors.back().time_s;
        Slices slices(begin, end, slices_of_log);
        for (const auto& error : errors)
            slices.add(error.time_s, std::max(error.distance_m, smallest_error_m));
        PlotLine line = slices.means();
        line.name = d.variant.name;
        line.colour = d.colour;
        lines.push_back(std::move(line));
    }
    PlotLook look;
    look.x_label = "time in the log [s]";
    look.y_label = "position error [m], logarithmic";
    look.log_y = true;
    return {
        "errors", "Error over time",
        "Mean position error in slices of the log, of each variant's worst run. Lower is better; "
        "less than a millimetre is drawn as a millimetre.",
        draw_svg_plot(lines, look)};
}

ComparisonPlot plot_of_error_shares(const std::vector<Drawn>& drawn)
{
    std::vector<PlotLine> lines;
    for (const auto& d : drawn)
    {
        if (!d.run.accuracy) continue;
        PlotLine line{d.variant.name, d.colour, {}, {}};
        for (const auto& error : d.run.accuracy->errors)
            line.x.push_back(std::max(error.distance_m, smallest_error_m));
        std::sort(line.x.begin(), line.x.end());
        for (std::size_t i = 0; i < line.x.size(); ++i)
            line.y.push_back(
                100.0 * static_cast<double>(i + 1) / static_cast<double>(line.x.size()));
        lines.push_back(std::move(line));
    }
    PlotLook look;
    look.x_label = "position error [m], logarithmic";
    look.y_label = "share of the errors at most this large [%]";
    look.log_x = true;
    return {
        "error_shares", "How large the errors are",
        "Read it so: at 0.1 m the curve's height is the share of errors that are 0.1 m or less. "
        "The farther left and up a curve, the better.",
        draw_svg_plot(lines, look)};
}

/// Without truth: how far the others are from the first variant.
ComparisonPlot plot_of_differences(const std::vector<Drawn>& drawn)
{
    const auto& reference = drawn.front().run.trajectory;
    std::vector<PlotLine> lines;
    for (std::size_t d = 1; d < drawn.size(); ++d)
    {
        const auto& path = drawn[d].run.trajectory;
        PlotLine line{drawn[d].variant.name, drawn[d].colour, {}, {}};
        for (std::size_t i = 0; i < std::min(path.size(), reference.size()); ++i)
        {
            line.x.push_back(static_cast<double>(i + 1));
            line.y.push_back(std::hypot(
                path[i].pose.x - reference[i].pose.x, path[i].pose.y - reference[i].pose.y));
        }
        lines.push_back(std::move(line));
    }
    PlotLook look;
    look.x_label = "scan";
    look.y_label = "distance to " + drawn.front().variant.name + " [m], log.";
    look.log_y = true;
    return {
        "differences", "How far the paths lie apart",
        "The distance of each path to that of " + drawn.front().variant.name +
            " at the same scan. This is no error: without a truth nobody knows which one is "
            "right.",
        draw_svg_plot(lines, look)};
}

ComparisonPlot plot_of_times(const std::vector<Drawn>& drawn)
{
    std::vector<PlotLine> lines;
    for (const auto& d : drawn)
    {
        if (d.variant.is_reference) continue;
        const auto& times_ms = d.run.scan_cpu_ms;
        Slices slices(0, static_cast<double>(times_ms.size()), slices_of_log);
        for (std::size_t i = 0; i < times_ms.size(); ++i)
            slices.add(static_cast<double>(i), static_cast<double>(times_ms[i]));
        PlotLine means = slices.means(), highest = slices.highest();
        highest.is_faint = true;
        means.name = d.variant.name;
        means.colour = highest.colour = d.colour;
        lines.push_back(std::move(means));
        lines.push_back(std::move(highest));
    }
    PlotLook look;
    look.x_label = "scan";
    look.y_label = "processor time per scan [ms], log.";
    look.log_y = true;
    return {
        "times", "Time per scan over the log",
        "Thick: the mean in slices of the log; thin: the slowest scan of each slice. A line that "
        "rises to the right is a program whose cost grows with its map.",
        draw_svg_plot(lines, look)};
}
}  // namespace

std::string variant_colour(std::size_t index)
{
    // Told apart by people who see red and green alike, too.
    static const std::array<const char*, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                    "#e69f00", "#56b4e9", "#7a5195", "#8c8c8c"};
    return colours[index % colours.size()];
}

std::vector<ComparisonPlot> comparison_plots(const Comparison& comparison)
{
    const auto drawn = drawn_runs(comparison);
    if (drawn.empty()) return {};
    std::vector<ComparisonPlot> plots{plot_of_paths(drawn)};
    if (comparison.truth_kind != TruthKind::None)
    {
        plots.push_back(plot_of_errors(drawn));
        plots.push_back(plot_of_error_shares(drawn));
    }
    else if (drawn.size() > 1)
        plots.push_back(plot_of_differences(drawn));
    plots.push_back(plot_of_times(drawn));
    return plots;
}
}  // namespace rtob

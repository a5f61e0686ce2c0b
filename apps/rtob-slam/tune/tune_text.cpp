// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/svg_plot.h>
#include <rtob/map/options_io.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "tune/tune_job.h"

namespace rtob
{
namespace
{
std::string fixed(double value, int digits)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string figures_cells(const TuneFigures& figures)
{
    return fixed(100 * figures.worst_m, 2) + " | " + fixed(100 * figures.median_m, 2) + " | " +
           std::to_string(figures.lost_scans) + " | " + fixed(figures.p50_ms, 2) + " | " +
           fixed(figures.p99_ms, 2);
}

constexpr const char* columns =
    "worst RMS, cm | median RMS, cm | scans LOST | p50, ms | p99, ms "
    "|\n|---|---|---|---|---|---|\n";

std::string curve_text(const TuneCurve& curve, double budget_ms)
{
    const auto chosen = chosen_value(curve, budget_ms);
    std::string text = "\n## " + curve.sweep.name();
    if (!curve.sweep.density.empty()) text += ", with the density " + curve.sweep.density;
    text += "\n\n| value | " + std::string(columns);
    for (const auto& [value, figures] : curve.points)
        text += "| " + value + (value == curve.value_before ? " (as it was)" : "") +
                (value == chosen ? " **best**" : "") + " | " + figures_cells(figures) + " |\n";
    if (chosen.empty()) text += "\nNone is feasible.\n";
    return text;
}

/// All keys in which two groups of options differ, as lines of an .ini.
template <class Options>
std::string difference(const char* section, const Options& options)
{
    std::vector<std::string> defaults;
    const Options untouched{};
    Options::fields(
        untouched, [&](const char*, const auto& value, const char*)
        { defaults.push_back(option_text(value)); });
    std::string lines;
    std::size_t next = 0;
    Options::fields(
        options,
        [&](const char* key, const auto& value, const char*)
        {
            const auto text = option_text(value);
            if (text != defaults[next++]) lines += std::string(key) + " = " + text + "\n";
        });
    return lines.empty() ? "" : "\n[" + std::string(section) + "]\n" + lines;
}
}  // namespace

std::string tuning_text(const TuneJob& job, const TuneResult& result)
{
    std::string text = "# Tuning on " + job.source + "\n\nBudget " + fixed(job.budget_ms, 1) +
                       " ms for 99 % of the scans, " + std::to_string(job.seeds) +
                       " seeds. One option is changed at a time, all else as it was. `tune.ini` "
                       "holds the suggestion.\n\n| | " +
                       columns + "| as it was | " + figures_cells(result.before) +
                       " |\n| suggested | " + figures_cells(result.after) + " |\n";
    if (is_feasible(result.before, job.budget_ms) && is_less_accurate(result.after, result.before))
        text +=
            "\nThe suggestion is less accurate than what it started from: the seeds differ by more "
            "than the values do. Keep what you had, or tune with more seeds and scans.\n";
    for (const auto& curve : result.curves) text += curve_text(curve, job.budget_ms);
    return text;
}

std::string tuning_ini(const TuneJob& job, const TuneResult& result)
{
    std::string text = "# Suggested by rtob-slam tune on " + job.source + " for " +
                       fixed(job.budget_ms, 1) + " ms a scan:\n# " +
                       fixed(100 * result.after.worst_m, 2) + " cm RMS (worst of " +
                       std::to_string(job.seeds) + " seeds), p99 " + fixed(result.after.p99_ms, 2) +
                       " ms. What is not here has its default.\n";
    RunConfig::sections(
        result.suggested,
        [&](const char* section, const auto& options) { text += difference(section, options); });
    return text;
}

std::string tuning_plot(const TuneCurve& curve, double budget_ms)
{
    PlotLine error{"worst RMS, cm", "#c0392b", {}, {}, false};
    PlotLine time{"p99, ms", "#1f6fb2", {}, {}, false};
    PlotLine budget{"budget, ms", "#999999", {}, {}, true};
    double place = 0;
    for (const auto& [value, figures] : curve.points)
    {
        char* end = nullptr;
        const double number = std::strtod(value.c_str(), &end);
        const double x = *end == '\0' ? number : ++place;  // names stand side by side
        for (auto* line : {&error, &time, &budget}) line->x.push_back(x);
        error.y.push_back(100 * figures.worst_m);
        time.y.push_back(figures.p99_ms);
        budget.y.push_back(budget_ms);
    }
    PlotLook look;
    look.x_label = curve.sweep.name();
    look.y_label = "cm, ms";
    look.log_y = true;
    return draw_svg_plot({error, time, budget}, look);
}
}  // namespace rtob

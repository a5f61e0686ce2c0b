// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/system/string_utils.h>
#include <rtob/eval/comparison_report.h>
#include <rtob/eval/svg_plot.h>

#include <fstream>
#include <iterator>

#include "comparison_plots.h"
#include "comparison_table.h"
#include "plot_axis.h"

namespace rtob
{
namespace
{
constexpr const char* style = R"(
body { font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; color: #1f2933; background: #f7f9fb;
       max-width: 1180px; margin: 0 auto; padding: 24px; }
h1 { font-size: 28px; } h2 { margin-top: 40px; font-size: 21px; }
.sheet { background: #fff; border: 1px solid #d9dee3; border-radius: 6px; padding: 16px;
         overflow-x: auto; }
table { border-collapse: collapse; font-size: 14px; width: 100%; }
th, td { padding: 6px 8px; text-align: right; vertical-align: top; border-top: 1px solid #e9edf0; }
thead th { border-top: 0; font-weight: 600; vertical-align: bottom; }
th:first-child, td.failed { text-align: left; } th:first-child { white-space: nowrap; }
small { display: block; color: #6b7785; font-weight: 400; white-space: nowrap; font-size: 11.5px; }
.failed, .failure { color: #b3261e; }
.swatch { display: inline-block; width: 12px; height: 12px; border-radius: 3px; margin-right: 6px; }
.maps { display: grid; grid-template-columns: repeat(2, 1fr); gap: 16px; }
figure { margin: 0; } figure img, figure svg { width: 100%; height: auto; }
figcaption { font-size: 14px; color: #52606d; }
dt { font-weight: 600; margin-top: 8px; } dd { margin-left: 20px; color: #3e4c59; }
code { background: #eef1f4; padding: 1px 4px; overflow-wrap: anywhere; }
)";

std::string swatch(std::size_t variant)
{
    return "<span class=\"swatch\" style=\"background:" + variant_colour(variant) + "\"></span>";
}

std::string heading(const std::string& text)
{
    return "<h2>" + escaped(text) + "</h2>\n";
}

std::string list_of(const std::vector<std::string>& items)
{
    std::string html = "<ul>\n";
    for (const auto& item : items) html += "<li>" + escaped(item) + "</li>\n";
    return html + "</ul>\n";
}

std::string table_html(const ComparisonTable& table)
{
    std::string html = "<div class=\"sheet\"><table>\n<thead><tr><th>variant</th>";
    for (const auto& column : table.columns)
        html += "<th title=\"" + escaped(column.meaning) + "\">" + escaped(column.title) +
                "<small>" + escaped(column.unit) + "</small></th>";
    html += "</tr></thead>\n<tbody>\n";
    for (std::size_t r = 0; r < table.rows.size(); ++r)
    {
        const auto& row = table.rows[r];
        html += "<tr><th>" + swatch(r) + escaped(row.name) + "</th>";
        for (const auto& cell : row.cells)
            html +=
                "<td>" + escaped(cell.figure) + "<small>" + escaped(cell.spread) + "</small></td>";
        if (row.cells.empty())
            html += "<td class=\"failed\" colspan=\"" + std::to_string(table.columns.size()) +
                    "\">failed: " + escaped(row.failure) + "</td>";
        html += "</tr>\n";
    }
    html += "</tbody></table></div>\n";
    for (const auto& row : table.rows)
        if (!row.cells.empty() && !row.failure.empty())
            html += "<p class=\"failure\">" + escaped(row.name + ": " + row.failure) + "</p>\n";
    return html;
}

std::string meanings_html(const ComparisonTable& table)
{
    std::string html = "<details open><summary>What the columns mean</summary><dl>\n";
    for (const auto& column : table.columns)
        html += "<dt>" + escaped(column.title + " [" + column.unit + "]") + "</dt><dd>" +
                escaped(column.meaning) + "</dd>\n";
    return html + "</dl></details>\n";
}

std::string variants_html(const Comparison& comparison)
{
    std::string html = heading("What was compared") + "<dl>\n";
    for (std::size_t v = 0; v < comparison.variants.size(); ++v)
    {
        const auto& variant = comparison.variants[v];
        html +=
            "<dt>" + swatch(v) + escaped(variant.name) + "</dt><dd>" + escaped(variant.description);
        if (!variant.settings.empty())
            html += " Settings: <code>" + escaped(variant.settings) + "</code>";
        html += "</dd>\n";
    }
    return html + "</dl>\n";
}

/// The picture itself in the page, so that the page can be sent around by itself.
std::string embedded_png(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) return {};
    const std::vector<std::uint8_t> png{std::istreambuf_iterator<char>(in), {}};
    std::string text;
    mrpt::system::encodeBase64(png, text);
    return "<img alt=\"\" src=\"data:image/png;base64," + text + "\">";
}

std::string error_text(const ComparedRun& run)
{
    if (!run.accuracy) return {};
    return ", mean error " + short_number(run.accuracy->distance_m.mean) + " m";
}

/// One picture of each variant, side by side.
std::string pictures_html(
    const Comparison& comparison, const std::string& folder, const std::string& picture)
{
    std::string html = "<div class=\"maps\">\n";
    for (std::size_t v = 0; v < comparison.variants.size(); ++v)
    {
        const auto& variant = comparison.variants[v];
        const auto figures = figures_of(variant);
        if (figures.worst == nullptr || (variant.is_reference && picture == "map.png")) continue;
        const std::string png = embedded_png(folder + "/" + figures.worst->folder + "/" + picture);
        if (png.empty()) continue;
        html += "<figure class=\"sheet\">" + png + "<figcaption>" + swatch(v) +
                escaped(variant.name + error_text(*figures.worst)) + "</figcaption></figure>\n";
    }
    return html + "</div>\n";
}

std::string plots_html(const Comparison& comparison)
{
    std::string html;
    for (const auto& plot : comparison_plots(comparison))
        html += heading(plot.title) + "<figure class=\"sheet\">" + plot.svg + "<figcaption>" +
                escaped(plot.caption) + "</figcaption></figure>\n";
    return html;
}

std::string machine_html(const Comparison& comparison)
{
    std::string html = heading("To repeat it") + "<p><code>" + escaped(comparison.command) +
                       "</code></p>\n<table><tbody>\n";
    for (const auto& [name, value] : comparison.machine)
        html += "<tr><th>" + escaped(name) + "</th><td style=\"text-align:left\">" +
                escaped(value) + "</td></tr>\n";
    return html + "</tbody></table>\n";
}
}  // namespace

std::string comparison_html(const Comparison& comparison, const std::string& folder)
{
    const auto table = comparison_table(comparison);
    const std::string title = escaped(comparison_title(comparison));
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                       title + "</title><style>" + style + "</style></head><body>\n<h1>" + title +
                       "</h1>\n<p>" + escaped(comparison_summary(comparison)) + "</p>\n<p>" +
                       escaped(truth_sentence(comparison)) + "</p>\n";
    html += variants_html(comparison);
    html += heading("In short") + list_of(comparison_findings(comparison));
    if (!comparison.remarks.empty()) html += heading("Remarks") + list_of(comparison.remarks);
    html += heading("Figures") + "<p>" + escaped(figures_sentence(comparison)) + "</p>\n" +
            table_html(table) + meanings_html(table);
    html += heading("The scans, put where each variant says the vehicle was") +
            "<p>Drawn alike for all, so that just the paths differ. Sharp, single walls: the path "
            "is right. Doubled or blurred walls: it is not.</p>\n" +
            pictures_html(comparison, folder, "scans.png");
    html += plots_html(comparison);
    html += heading("The variants' own maps") +
            "<p>What each of them kept of the scans to match against.</p>\n" +
            pictures_html(comparison, folder, "map.png");
    return html + machine_html(comparison) + "</body></html>\n";
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/comparison_report.h>

#include "comparison_plots.h"
#include "comparison_table.h"

namespace rtob
{
namespace
{
/// A table's cells must not hold what ends them.
std::string in_cell(std::string text)
{
    for (auto& letter : text)
        if (letter == '|' || letter == '\n') letter = '/';
    return text;
}

std::string cell_text(const TableCell& cell)
{
    if (cell.spread.empty()) return cell.figure;
    const bool is_deviation = cell.spread.rfind("±", 0) == 0;
    return cell.figure + (is_deviation ? " " + cell.spread : " (" + cell.spread + ")");
}

std::string table_text(const ComparisonTable& table)
{
    std::string head = "| variant |", rule = "|---|";
    for (const auto& column : table.columns)
    {
        head += " " + column.title + " [" + column.unit + "] |";
        rule += "---|";
    }
    std::string text = head + "\n" + rule + "\n";
    for (const auto& row : table.rows)
    {
        text += "| " + row.name + " |";
        for (const auto& cell : row.cells) text += " " + cell_text(cell) + " |";
        if (row.cells.empty())
            text += " failed: " + in_cell(row.failure) + " |" +
                    std::string(table.columns.size() - 1, '|');
        text += "\n";
    }
    return text;
}

void add_list(std::string& text, const std::string& title, const std::vector<std::string>& items)
{
    if (items.empty()) return;
    text += "\n## " + title + "\n\n";
    for (const auto& item : items) text += "- " + item + "\n";
}

std::vector<std::string> explanations(const ComparisonTable& table)
{
    std::vector<std::string> items;
    for (const auto& column : table.columns)
        items.push_back("**" + column.title + "** [" + column.unit + "]: " + column.meaning);
    for (const auto& row : table.rows)
        if (!row.cells.empty() && !row.failure.empty())
            items.push_back("**" + row.name + "**: " + row.failure);
    return items;
}

std::vector<std::string> variant_items(const Comparison& comparison)
{
    std::vector<std::string> items;
    for (const auto& variant : comparison.variants)
        items.push_back(
            "**" + variant.name + "**: " + variant.description +
            (variant.settings.empty() ? "" : " Settings: `" + variant.settings + "`."));
    return items;
}
}  // namespace

std::string comparison_markdown(const Comparison& comparison)
{
    const auto table = comparison_table(comparison);
    std::string text = "# " + comparison_title(comparison) + "\n\n" +
                       comparison_summary(comparison) + " " + truth_sentence(comparison) + "\n";
    add_list(text, "What was compared", variant_items(comparison));
    add_list(text, "In short", comparison_findings(comparison));
    add_list(text, "Remarks", comparison.remarks);
    text += "\n## Figures\n\n" + figures_sentence(comparison) + "\n\n" + table_text(table);
    add_list(text, "How to read them", explanations(table));
    for (const auto& plot : comparison_plots(comparison))
        text += "\n## " + plot.title + "\n\n![" + plot.title + "](" + plot.name + ".svg)\n\n" +
                plot.caption + "\n";
    text += "\n## To repeat it\n\n    " + comparison.command + "\n\n";
    for (const auto& [name, value] : comparison.machine) text += "- " + name + ": " + value + "\n";
    return text;
}
}  // namespace rtob

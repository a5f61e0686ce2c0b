// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/eval/comparison.h>

#include <string>
#include <vector>

namespace rtob
{
struct TableColumn
{
    std::string title;
    std::string unit;
    std::string meaning;  ///< a sentence
};

/// A figure, and under it how far it lay apart in the runs.
struct TableCell
{
    std::string figure;
    std::string spread;
};

struct TableRow
{
    std::string name;
    std::vector<TableCell> cells;  ///< none where every run failed
    std::string failure;           ///< also where just some of the runs did
};

/// What a report shows of a comparison, as text.
struct ComparisonTable
{
    std::vector<TableColumn> columns;  ///< without the first, the names
    std::vector<TableRow> rows;
};

/// 1234567 as "1 234 567", smaller numbers with three digits that mean something.
[[nodiscard]] std::string readable(double value);

[[nodiscard]] ComparisonTable comparison_table(const Comparison& comparison);

/// What the table says in a few sentences, for people who read no tables.
[[nodiscard]] std::vector<std::string> comparison_findings(const Comparison& comparison);

[[nodiscard]] std::string comparison_title(const Comparison& comparison);
/// What was done, in a few sentences.
[[nodiscard]] std::string comparison_summary(const Comparison& comparison);

/// Which of several runs a figure of the table is.
[[nodiscard]] std::string figures_sentence(const Comparison& comparison);

/// What the trajectories were judged by, in a sentence.
[[nodiscard]] std::string truth_sentence(const Comparison& comparison);
}  // namespace rtob

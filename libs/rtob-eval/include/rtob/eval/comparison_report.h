// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/eval/comparison.h>

#include <string>

namespace rtob
{
/// Writes into the folder: report.html (needs no other file), report.md with its plots *.svg, and
/// results.csv, a line a run. The pictures map.png and scans.png are taken from the runs' folders
/// where they are. Throws std::runtime_error naming a file that cannot be written.
void write_comparison_report(const std::string& folder, const Comparison& comparison);

/// results.csv: every run with its figures; failed ones have their reason in the last column.
[[nodiscard]] std::string comparison_csv(const Comparison& comparison);
[[nodiscard]] std::string comparison_markdown(const Comparison& comparison);
/// @param folder of the report: where the runs' pictures are looked for
[[nodiscard]] std::string comparison_html(const Comparison& comparison, const std::string& folder);
}  // namespace rtob

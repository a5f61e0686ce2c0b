// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/comparison_report.h>
#include <rtob/io/atomic_file.h>

#include "comparison_plots.h"

namespace rtob
{
void write_comparison_report(const std::string& folder, const Comparison& comparison)
{
    write_text(folder + "/results.csv", comparison_csv(comparison));
    for (const auto& plot : comparison_plots(comparison))
        write_text(folder + "/" + plot.name + ".svg", plot.svg);
    write_text(folder + "/report.md", comparison_markdown(comparison));
    write_text(folder + "/report.html", comparison_html(comparison, folder));
}
}  // namespace rtob

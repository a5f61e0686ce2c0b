// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/eval/comparison.h>

#include <string>
#include <vector>

namespace rtob
{
struct ComparisonPlot
{
    std::string name;  ///< of its file, without the ending
    std::string title, caption;
    std::string svg;
};

/// Paths, errors where the truth is known, and times, of each variant's worst run.
[[nodiscard]] std::vector<ComparisonPlot> comparison_plots(const Comparison& comparison);

/// The colour of the variant with this place in the list, as in CSS.
[[nodiscard]] std::string variant_colour(std::size_t index);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace rtob
{
/// The value that this share of the values does not exceed (nearest rank); 0 of none.
[[nodiscard]] double percentile(std::vector<float> values, double share);

/// A figure that was measured several times.
struct Spread
{
    double median = 0;  ///< of an even number of values the mean of the middle two
    double lowest = 0;
    double highest = 0;
};

/// All 0 of no values.
[[nodiscard]] Spread spread_of(std::vector<double> values);
}  // namespace rtob

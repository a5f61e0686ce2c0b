// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace rtob::test
{
/// Pearson's statistic of counts against shares, as standard deviations of a normal variable
/// (Wilson and Hilferty's cube root): above 4 has a chance of 3e-5 when the shares are right.
/// Bins that expect fewer than 5 are joined; a count where none can be is infinitely wrong.
inline double chi_square_deviation(
    const std::vector<std::uint64_t>& counts, const std::vector<double>& weights)
{
    const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
    const double weight_sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    double statistic = 0, bins = 0, expected = 0, observed = 0;
    const auto close_bin = [&]
    {
        statistic += (observed - expected) * (observed - expected) / expected;
        ++bins;
        expected = observed = 0;
    };
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
        if (weights[i] <= 0 && counts[i] > 0) return std::numeric_limits<double>::infinity();
        expected += total * weights[i] / weight_sum;
        observed += static_cast<double>(counts[i]);
        if (expected >= 5) close_bin();
    }
    if (expected > 0) close_bin();
    const double freedom = bins - 1, spread = 2 / (9 * freedom);
    return (std::cbrt(statistic / freedom) - (1 - spread)) / std::sqrt(spread);
}
}  // namespace rtob::test

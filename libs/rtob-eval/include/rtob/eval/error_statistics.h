// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace rtob
{
/// What evo reports of a list of errors.
struct ErrorStatistics
{
    double rmse = 0;
    double mean = 0;
    double median = 0;  ///< the mean of the two in the middle when the count is even
    double std = 0;     ///< of the values themselves (divided by n)
    double min = 0;
    double max = 0;
    double sse = 0;  ///< sum of squares, in the unit squared
};

/// Throws std::invalid_argument for an empty list.
[[nodiscard]] ErrorStatistics error_statistics(std::vector<double> errors);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/error_statistics.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace rtob
{
ErrorStatistics error_statistics(std::vector<double> errors)
{
    if (errors.empty()) throw std::invalid_argument("no errors to make statistics of");
    std::sort(errors.begin(), errors.end());
    const auto n = static_cast<double>(errors.size());
    const auto middle = errors.size() / 2;

    ErrorStatistics result;
    result.min = errors.front();
    result.max = errors.back();
    result.median =
        errors.size() % 2 == 1 ? errors[middle] : (errors[middle - 1] + errors[middle]) / 2;
    result.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / n;
    double deviations = 0;
    for (const double error : errors)
    {
        result.sse += error * error;
        deviations += (error - result.mean) * (error - result.mean);
    }
    result.rmse = std::sqrt(result.sse / n);
    result.std = std::sqrt(deviations / n);
    return result;
}
}  // namespace rtob

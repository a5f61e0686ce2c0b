// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/spread.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtob
{
double percentile(std::vector<float> values, double share)
{
    if (values.empty()) return 0;
    const double rank = std::ceil(share * static_cast<double>(values.size()));
    const auto index = static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
    std::nth_element(values.begin(), values.begin() + index, values.end());
    return static_cast<double>(values[static_cast<std::size_t>(index)]);
}

Spread spread_of(std::vector<double> values)
{
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const std::size_t upper = values.size() / 2, lower = (values.size() - 1) / 2;
    return {(values[lower] + values[upper]) / 2, values.front(), values.back()};
}
}  // namespace rtob

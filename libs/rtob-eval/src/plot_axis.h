// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace rtob
{
/// A number as people write it: three digits that mean something, no exponent, no trailing zeros.
[[nodiscard]] std::string short_number(double value);

/// One axis of a plot: which values it shows, and where.
class PlotAxis
{
 public:
    /// Grown to a width above 0; for a logarithmic axis to values above 0.
    PlotAxis(double low, double high, bool is_logarithmic);

    /// 0 at its low end, 1 at its high end; outside for values that it does not show.
    [[nodiscard]] double place(double value) const;
    /// Round numbers on it, about `wanted` of them: 1, 2 or 5 times a power of ten.
    [[nodiscard]] std::vector<double> ticks(int wanted) const;

 private:
    [[nodiscard]] std::vector<double> logarithmicTicks() const;

    double low_, high_;
    bool is_logarithmic_;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "plot_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace rtob
{
namespace
{
constexpr double kSmallestShown = 1e-4;  // of a logarithmic axis

/// 1, 2 or 5 times a power of ten, at least `width` divided by the wanted number of steps.
double round_step(double width, int wanted)
{
    const double rough = width / wanted;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= rough * 0.999) return digit * power;
    return 10 * power;
}
}  // namespace

std::string short_number(double value)
{
    if (value == 0) return "0";
    const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), "%.*f", std::clamp(2 - magnitude, 0, 12), value);
    std::string number = text.data();
    if (number.find('.') == std::string::npos) return number;
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    return number;
}

PlotAxis::PlotAxis(double low, double high, bool is_logarithmic)
    : low_(low), high_(high), is_logarithmic_(is_logarithmic)
{
    if (is_logarithmic_)
    {
        low_ = std::log10(std::max(low, kSmallestShown));
        high_ = std::log10(std::max(high, kSmallestShown));
    }
    if (high_ - low_ > 1e-9) return;
    low_ -= 0.5;
    high_ += 0.5;
}

double PlotAxis::place(double value) const
{
    const double on_axis =
        is_logarithmic_ ? std::log10(std::max(value, kSmallestShown / 10)) : value;
    return (on_axis - low_) / (high_ - low_);
}

std::vector<double> PlotAxis::logarithmicTicks() const
{
    const bool is_wide = high_ - low_ > 2.5;
    std::vector<double> ticks;
    for (int power = static_cast<int>(std::floor(low_)); power <= std::ceil(high_); ++power)
        for (const double digit : {1.0, 2.0, 5.0})
        {
            const double at = power + std::log10(digit);
            if (is_wide && digit != 1.0) continue;
            if (at > low_ - 1e-9 && at < high_ + 1e-9) ticks.push_back(std::pow(10.0, at));
        }
    return ticks;
}

std::vector<double> PlotAxis::ticks(int wanted) const
{
    if (is_logarithmic_) return logarithmicTicks();
    const double step = round_step(high_ - low_, wanted);
    std::vector<double> ticks;
    for (double k = std::ceil(low_ / step - 1e-9); k * step <= high_ + 1e-9 * step; ++k)
        ticks.push_back(k * step);
    return ticks;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "figures.h"

#include <cstdio>

namespace rtob
{
std::string fixed(double value, int digits)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string percent(double share)
{
    const double figure = 100 * share;
    return fixed(figure, figure != 0 && figure < 0.095 ? 3 : 1) + " %";
}

std::string counted(std::uint64_t count, const std::string& noun)
{
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

double share_of(std::uint64_t part, std::uint64_t whole)
{
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}
}  // namespace rtob

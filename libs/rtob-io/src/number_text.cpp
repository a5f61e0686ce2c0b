// SPDX-License-Identifier: BSD-3-Clause
#include "number_text.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

namespace rtob
{
namespace
{
template <class Number>
void write_shortest(std::ostream& out, Number value)
{
    std::array<char, 40> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    out.write(text.data(), end.ptr - text.data());
}
}  // namespace

void write_fixed(std::ostream& out, double value, int decimals)
{
    std::array<char, 400> text;  // the largest double has 309 digits before the point
    const auto end = std::to_chars(
        text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    out.write(text.data(), end.ptr - text.data());
}

void write_exact(std::ostream& out, double value)
{
    write_shortest(out, value);
}

void write_exact(std::ostream& out, float value)
{
    write_shortest(out, value);
}

void write_exact(std::ostream& out, std::int64_t value)
{
    write_shortest(out, value);
}

void write_ticks_100ns(std::ostream& out, std::int64_t ticks)
{
    constexpr std::size_t decimals = 7;
    const auto magnitude = static_cast<std::uint64_t>(ticks);
    std::string digits = std::to_string(ticks < 0 ? 0 - magnitude : magnitude);
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    const std::string_view seconds(digits.data(), digits.size() - decimals);
    std::string_view fraction(digits.data() + seconds.size(), decimals);
    if (fraction.back() == '0') fraction.remove_suffix(1);
    out << (ticks < 0 ? "-" : "") << seconds << '.' << fraction;
}
}  // namespace rtob

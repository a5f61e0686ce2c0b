// SPDX-License-Identifier: BSD-3-Clause
#include "text_fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rtob
{
namespace
{
bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

[[noreturn]] void fail(std::string_view word, const std::string& expected)
{
    constexpr std::size_t most_shown = 40;
    if (word.empty()) throw FieldError("the line ends where " + expected + " was expected");
    throw FieldError(
        "'" + std::string(word.substr(0, most_shown)) + "' stands where " + expected +
        " was expected");
}
}  // namespace

std::string_view TextFields::next_word()
{
    const char* begin = rest_.data();
    const char* const line_end = begin + rest_.size();
    while (begin != line_end && is_blank(*begin)) ++begin;
    const char* end = begin;
    while (end != line_end && !is_blank(*end)) ++end;
    rest_ = {end, static_cast<std::size_t>(line_end - end)};
    return {begin, static_cast<std::size_t>(end - begin)};
}

std::string_view TextFields::word(const char* name)
{
    const auto text = next_word();
    if (text.empty()) fail(text, name);
    return text;
}

double TextFields::number(const char* name)
{
    const auto text = next_word();
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range) return std::nan("");
    if (text.empty() || error != std::errc() || end != text.data() + text.size())
        fail(text, "a number (" + std::string(name) + ")");
    return value;
}

double TextFields::finite_number(const char* name)
{
    const double value = number(name);
    if (!std::isfinite(value)) throw FieldError(std::string(name) + " is not a finite number");
    return value;
}

std::size_t TextFields::count(const char* name, std::size_t most)
{
    const auto text = next_word();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size() || value > most)
        fail(text, std::string(name) + " (0 to " + std::to_string(most) + ")");
    return value;
}

std::int64_t parse_ticks_100ns(std::string_view seconds, const char* name)
{
    constexpr int fraction_digits = 7;
    constexpr double ticks_per_second = 1e7;
    constexpr double most_seconds = 1e11;  // the year 5138
    const std::string expected = std::string("a time in seconds (") + name + ")";

    const char* const end = seconds.data() + seconds.size();
    double value = 0;
    const auto [read_end, error] = std::from_chars(seconds.data(), end, value);
    const bool is_number = !seconds.empty() && read_end == end && error == std::errc();
    if (!is_number || !(std::abs(value) < most_seconds)) fail(seconds, expected);
    if (seconds.find_first_of("eE") != std::string_view::npos)
        return std::llround(value * ticks_per_second);

    std::int64_t ticks = 0;
    int fraction_place = -1;  // -1 before the point
    for (const char c : seconds.substr(seconds.front() == '-' ? 1 : 0))
    {
        if (c == '.')
            fraction_place = 0;
        else if (fraction_place < fraction_digits)
        {
            ticks = 10 * ticks + (c - '0');
            if (fraction_place >= 0) ++fraction_place;
        }
        else if (fraction_place++ == fraction_digits && c >= '5')
            ++ticks;
    }
    for (int place = std::max(0, fraction_place); place < fraction_digits; ++place) ticks *= 10;
    return seconds.front() == '-' ? -ticks : ticks;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "text_fields.h"

#include <charconv>
#include <cmath>

namespace rtob
{
namespace
{
constexpr std::string_view blanks = " \t";

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
    const auto begin = rest_.find_first_not_of(blanks);
    if (begin == std::string_view::npos)
    {
        rest_ = {};
        return {};
    }
    auto end = rest_.find_first_of(blanks, begin);
    if (end == std::string_view::npos) end = rest_.size();
    const auto word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return word;
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
    constexpr std::int64_t ticks_per_second = 10'000'000;
    constexpr std::int64_t most_seconds = 100'000'000'000;  // the year 5138
    const bool negative = !seconds.empty() && seconds.front() == '-';
    const auto digits = seconds.substr(negative ? 1 : 0);

    std::int64_t whole = 0;
    const char* const end = digits.data() + digits.size();
    const auto [point, error] = std::from_chars(digits.data(), end, whole);
    if (digits.empty() || digits.front() == '-' || error != std::errc() || whole > most_seconds)
        fail(seconds, std::string("a time in seconds (") + name + ")");
    std::int64_t ticks = whole * ticks_per_second;
    if (point != end)
    {
        if (*point != '.') fail(seconds, std::string("a time in seconds (") + name + ")");
        std::int64_t unit = ticks_per_second;
        int place = 0;
        for (const char* c = point + 1; c != end; ++c, ++place)
        {
            if (*c < '0' || *c > '9')
                fail(seconds, std::string("a time in seconds (") + name + ")");
            if (place < fraction_digits) ticks += (*c - '0') * (unit /= 10);
            if (place == fraction_digits && *c >= '5') ++ticks;
        }
    }
    return negative ? -ticks : ticks;
}
}  // namespace rtob

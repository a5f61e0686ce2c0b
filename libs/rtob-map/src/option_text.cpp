// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/map/option_text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rtob
{
namespace
{
[[noreturn]] void refuse(const std::string& text, const std::string& allowed)
{
    throw std::invalid_argument("'" + text + "' is not " + allowed);
}

/// std::from_chars: no locale, no leading blanks, and we see where it stopped.
template <class Number>
Number parsed_number(const std::string& text, const std::string& allowed)
{
    // People write "+1"; from_chars does not read it, and "+-1" must stay an error.
    const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    const char* const end = text.data() + text.size();
    Number number{};
    const auto [stop, error] = std::from_chars(text.data() + (has_plus ? 1 : 0), end, number);
    if (error != std::errc{} || stop != end) refuse(text, allowed);
    return number;
}

template <class Real>
Real parsed_real(const std::string& text)
{
    const std::string allowed = "a number such as 0.5, -2 or 1e-3";
    const Real number = parsed_number<Real>(text, allowed);
    if (std::isnan(number)) refuse(text, allowed);
    return number;
}

template <class Number>
std::string number_text(Number number)
{
    std::array<char, 64> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    if (error != std::errc{}) throw std::logic_error("a number longer than 64 characters");
    return {buffer.data(), end};
}

std::string lower_case(std::string text)
{
    std::transform(
        text.begin(), text.end(), text.begin(),
        [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}
}  // namespace

void parse_option(const std::string& text, double& value)
{
    value = parsed_real<double>(text);
}

void parse_option(const std::string& text, float& value)
{
    value = parsed_real<float>(text);
}

void parse_option(const std::string& text, int& value)
{
    value = parsed_number<int>(text, "a whole number from -2147483648 to 2147483647");
}

void parse_option(const std::string& text, unsigned& value)
{
    value = parsed_number<unsigned>(text, "a whole number from 0 to 4294967295");
}

void parse_option(const std::string& text, std::uint64_t& value)
{
    value = parsed_number<std::uint64_t>(text, "a whole number from 0 to 18446744073709551615");
}

void parse_option(const std::string& text, bool& value)
{
    static const std::array<std::pair<const char*, bool>, 8> words{
        {{"true", true},
         {"false", false},
         {"yes", true},
         {"no", false},
         {"on", true},
         {"off", false},
         {"1", true},
         {"0", false}}};
    const std::string lower = lower_case(text);
    for (const auto& [word, meaning] : words)
    {
        if (lower != word) continue;
        value = meaning;
        return;
    }
    refuse(text, "one of: true, false, yes, no, on, off, 1, 0");
}

void parse_option(const std::string& text, std::string& value)
{
    value = text;
}

std::string option_text(double value)
{
    return number_text(value);
}
std::string option_text(float value)
{
    return number_text(value);
}
std::string option_text(int value)
{
    return number_text(value);
}
std::string option_text(unsigned value)
{
    return number_text(value);
}
std::string option_text(std::uint64_t value)
{
    return number_text(value);
}
std::string option_text(bool value)
{
    return value ? "true" : "false";
}

std::string option_text(const std::string& value)
{
    // MRPT's reader trims blanks, expands "$", joins lines that end in a backslash and takes what
    // follows a blank and "//" for a comment; ours does the same with "#" and ";".
    const std::string padded = " " + value;
    for (const char* mark : {" //", " #", " ;", "\t//", "\t#", "\t;", "$", "\n", "\r"})
    {
        if (padded.find(mark) != std::string::npos)
            refuse(value, "a text without line breaks, '$' and comment marks");
    }
    const std::string blanks = " \t";
    const bool has_outer_blank = !value.empty() && (blanks.find(value.front()) != blanks.npos ||
                                                    blanks.find(value.back()) != blanks.npos);
    if (has_outer_blank || (!value.empty() && value.back() == '\\'))
        refuse(value, "a text without outer blanks or a final backslash");
    return value;
}
}  // namespace rtob

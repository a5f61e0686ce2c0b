// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/enum_names.h>

#include <cstdint>
#include <string>
#include <type_traits>

/// One option value as text and back. Reading is strict: the whole text must be the value, or
/// std::invalid_argument says what is allowed. Writing then reading gives the same bits.
namespace rtob
{
/// Decimal or "inf"; never NaN, which would slip through every range check.
void parse_option(const std::string& text, double& value);
void parse_option(const std::string& text, float& value);
void parse_option(const std::string& text, int& value);
void parse_option(const std::string& text, unsigned& value);
void parse_option(const std::string& text, std::uint64_t& value);
/// true, false, yes, no, on, off, 1, 0; in any case.
void parse_option(const std::string& text, bool& value);
void parse_option(const std::string& text, std::string& value);

template <class E, class = std::enable_if_t<std::is_enum_v<E>>>
void parse_option(const std::string& text, E& value)
{
    value = parse_enum<E>(text);
}

/// The shortest decimal that reads back as the same number.
[[nodiscard]] std::string option_text(double value);
[[nodiscard]] std::string option_text(float value);
[[nodiscard]] std::string option_text(int value);
[[nodiscard]] std::string option_text(unsigned value);
[[nodiscard]] std::string option_text(std::uint64_t value);
[[nodiscard]] std::string option_text(bool value);
/// Throws std::invalid_argument for a text that a configuration file cannot hold (see the .cpp).
[[nodiscard]] std::string option_text(const std::string& value);

template <class E, class = std::enable_if_t<std::is_enum_v<E>>>
[[nodiscard]] std::string option_text(E value)
{
    return std::string(name_of(value));
}
}  // namespace rtob

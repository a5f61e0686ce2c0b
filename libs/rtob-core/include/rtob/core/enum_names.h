// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/nearest_name.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Names of enums, as people type them. An enum E that has names declares, in its own namespace,
///     constexpr auto enum_names(E) { return std::array<std::pair<E, std::string_view>, N>{...}; }
/// and everything here finds that table by argument-dependent look-up.
namespace rtob
{
/// All names of E, in the order of its table.
template <class E>
[[nodiscard]] std::vector<std::string> all_names()
{
    std::vector<std::string> names;
    for (const auto& [value, name] : enum_names(E{})) names.emplace_back(name);
    return names;
}

/// The name of a value; throws std::invalid_argument for a number that is no value of E.
template <class E>
[[nodiscard]] std::string_view name_of(E wanted)
{
    for (const auto& [value, name] : enum_names(E{}))
        if (value == wanted) return name;
    throw std::invalid_argument(
        "no name for the value " + std::to_string(static_cast<long long>(wanted)) +
        "; named values: " + joined(all_names<E>()));
}

/// The value with exactly this name; throws std::invalid_argument that lists the names.
template <class E>
[[nodiscard]] E parse_enum(std::string_view text)
{
    for (const auto& [value, name] : enum_names(E{}))
        if (name == text) return value;
    const auto names = all_names<E>();
    const auto nearest = nearest_name(text, names);
    throw std::invalid_argument(
        "'" + std::string(text) + "' is not one of: " + joined(names) +
        (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}
}  // namespace rtob

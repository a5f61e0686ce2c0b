// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>

namespace rtob
{
constexpr double kRadToDeg = 57.29577951308232;

/// With so many digits behind the point.
[[nodiscard]] std::string fixed(double value, int digits);
/// "12.3 %"
[[nodiscard]] std::string percent(double share);
/// "1 scan", "2 scans"
[[nodiscard]] std::string counted(std::uint64_t count, const std::string& noun);
[[nodiscard]] double share_of(std::uint64_t part, std::uint64_t whole);
}  // namespace rtob

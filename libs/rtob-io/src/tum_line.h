// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string_view>

namespace rtob
{
constexpr int tum_position_decimals = 6;
constexpr int tum_turn_decimals = 9;
constexpr const char* tum_line_fix = "A TUM line is: time_s x y z qx qy qz qw";

/// A pose as a TUM file has it.
struct TumLine
{
    double time_s = 0;
    std::int64_t stamp_100ns = 0;  ///< the same, exactly
    double x = 0, y = 0, z = 0;
    double qx = 0, qy = 0, qz = 0, qw = 1;
};

/// Throws FieldError for anything but eight finite numbers with a unit quaternion.
[[nodiscard]] TumLine parse_tum_line(std::string_view text);
}  // namespace rtob

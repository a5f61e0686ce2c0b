// SPDX-License-Identifier: BSD-3-Clause
#include "tum_line.h"

#include <cmath>

#include "text_fields.h"

namespace rtob
{
TumLine parse_tum_line(std::string_view text)
{
    constexpr double norm_tolerance = 0.01;  // files with three decimals must pass
    TextFields fields(text);
    TumLine line;
    const auto time = fields.word("time");
    line.time_s = TextFields(time).finite_number("time");
    line.stamp_100ns = parse_ticks_100ns(time, "time");
    line.x = fields.finite_number("x");
    line.y = fields.finite_number("y");
    line.z = fields.finite_number("z");
    line.qx = fields.finite_number("qx");
    line.qy = fields.finite_number("qy");
    line.qz = fields.finite_number("qz");
    line.qw = fields.finite_number("qw");
    if (!fields.next_word().empty()) throw FieldError("the line goes on after its eight numbers");
    const double norm = std::hypot(std::hypot(line.qx, line.qy), std::hypot(line.qz, line.qw));
    if (!(std::abs(norm - 1) <= norm_tolerance))
        throw FieldError("qx qy qz qw is not a unit quaternion");
    return line;
}
}  // namespace rtob

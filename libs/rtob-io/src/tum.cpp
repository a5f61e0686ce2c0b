// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/atomic_file.h>
#include <rtob/io/tum.h>

#include <array>
#include <charconv>
#include <cmath>
#include <ostream>

#include "data_lines.h"
#include "text_fields.h"

namespace rtob
{
namespace
{
void write_number(std::ostream& out, double value, int decimals)
{
    std::array<char, 400> text;  // the largest double has 309 digits before the point
    const auto end = std::to_chars(
        text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    out.write(text.data(), end.ptr - text.data());
}

StampedPose2 parse_line(std::string_view line)
{
    constexpr double norm_tolerance = 0.01;  // files with three decimals must pass
    TextFields fields(line);
    StampedPose2 stamped;
    stamped.time_s = fields.finite_number("time");
    stamped.pose.x = fields.finite_number("x");
    stamped.pose.y = fields.finite_number("y");
    static_cast<void>(fields.finite_number("z"));
    const double qx = fields.finite_number("qx"), qy = fields.finite_number("qy");
    const double qz = fields.finite_number("qz"), qw = fields.finite_number("qw");
    if (!fields.next_word().empty()) throw FieldError("the line goes on after its eight numbers");
    const double norm2 = qx * qx + qy * qy + qz * qz + qw * qw;
    if (std::abs(std::sqrt(norm2) - 1) > norm_tolerance)
        throw FieldError("qx qy qz qw is not a unit quaternion");
    stamped.pose.yaw =
        wrap_angle(std::atan2(2 * (qw * qz + qx * qy), norm2 - 2 * (qy * qy + qz * qz)));
    return stamped;
}
}  // namespace

void write_tum(std::ostream& out, const std::vector<StampedPose2>& poses)
{
    constexpr int time_decimals = 6, position_decimals = 6, turn_decimals = 9;
    for (const auto& [time_s, pose] : poses)
    {
        write_number(out, time_s, time_decimals);
        for (const double coordinate : {pose.x, pose.y})
            write_number(out << ' ', coordinate, position_decimals);
        out << " 0 0 0";
        for (const double turn : {std::sin(pose.yaw / 2), std::cos(pose.yaw / 2)})
            write_number(out << ' ', turn, turn_decimals);
        out << '\n';
    }
}

void write_tum(const std::string& file, const std::vector<StampedPose2>& poses)
{
    AtomicFile out(file);
    write_tum(out.stream(), poses);
    out.commit();
}

std::vector<StampedPose2> read_tum(const std::string& file)
{
    std::vector<StampedPose2> poses;
    for_each_data_line(
        file, "A TUM line is: time_s x y z qx qy qz qw",
        [&](std::string_view line)
        {
            poses.push_back(parse_line(line));
            return true;
        });
    return poses;
}
}  // namespace rtob

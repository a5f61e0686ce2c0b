// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/atomic_file.h>
#include <rtob/io/tum.h>

#include <cmath>
#include <ostream>

#include "data_lines.h"
#include "number_text.h"
#include "tum_line.h"

namespace rtob
{
namespace
{
StampedPose2 from_above(const TumLine& line)
{
    const double norm2 =
        line.qx * line.qx + line.qy * line.qy + line.qz * line.qz + line.qw * line.qw;
    const double yaw = std::atan2(
        2 * (line.qw * line.qz + line.qx * line.qy),
        norm2 - 2 * (line.qy * line.qy + line.qz * line.qz));
    return {line.time_s, {line.x, line.y, wrap_angle(yaw)}};
}
}  // namespace

void write_tum(std::ostream& out, const std::vector<StampedPose2>& poses)
{
    constexpr int time_decimals = 6;
    for (const auto& [time_s, pose] : poses)
    {
        write_fixed(out, time_s, time_decimals);
        for (const double coordinate : {pose.x, pose.y})
            write_fixed(out << ' ', coordinate, tum_position_decimals);
        out << " 0 0 0";
        for (const double turn : {std::sin(pose.yaw / 2), std::cos(pose.yaw / 2)})
            write_fixed(out << ' ', turn, tum_turn_decimals);
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
    DataLines lines(file, tum_line_fix);
    while (const auto line = lines.next(parse_tum_line)) poses.push_back(from_above(*line));
    return poses;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace rtob::test
{
inline std::string joined(const std::vector<std::string>& words)
{
    std::string line;
    for (const auto& word : words) line += (line.empty() ? "" : " ") + word;
    return line;
}

inline std::string ranges_text(std::size_t beams, const std::string& range = "2.5")
{
    return joined(std::vector<std::string>(beams, range));
}

/// A FLASER line. Poses are "x y theta".
inline std::string flaser(
    const std::string& count_and_ranges, const std::string& laser_pose,
    const std::string& odometry_pose, const std::string& stamp, const std::string& name = "FLASER")
{
    return joined({name, count_and_ranges, laser_pose, odometry_pose, stamp, "host", "0.1"}) + "\n";
}

inline std::string flaser_of(std::size_t beams)
{
    return flaser(
        std::to_string(beams) + (beams > 0 ? " " : "") + ranges_text(beams), "1 0 0", "1 0 0",
        "10.5");
}

struct RobotLaserText
{
    std::string name = "ROBOTLASER1";
    std::string start_angle = "-1.0", step = "0.5", max_range = "6";
    std::string count_and_ranges = "3 1 2 3";
    std::string remissions = "0";
    std::string laser_pose = "1 0 0", vehicle_pose = "1 0 0";
    std::string stamp = "10.5";

    std::string line() const
    {
        return joined(
                   {name, "0", start_angle, "3.14", step, max_range, "0.01", "0", count_and_ranges,
                    remissions, laser_pose, vehicle_pose, "0 0 0 0 0", stamp, "host", "0.1"}) +
               "\n";
    }
};
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#include "carmen_message.h"

#include <cmath>

namespace rtob
{
namespace
{
constexpr std::size_t most_beams = 100'000;
constexpr double pi = 3.14159265358979323846;

Pose2 parse_pose(TextFields& fields, const char* x, const char* y, const char* theta)
{
    Pose2 pose;
    pose.x = fields.finite_number(x);
    pose.y = fields.finite_number(y);
    pose.yaw = wrap_angle(fields.finite_number(theta));
    return pose;
}

std::int64_t parse_stamp(TextFields& fields)
{
    const auto stamp = parse_ticks_100ns(fields.word("ipc_timestamp"), "ipc_timestamp");
    // Tells a whole stamp from one that was cut with its line.
    static_cast<void>(fields.word("ipc_hostname"));
    return stamp;
}

void parse_ranges(TextFields& fields, std::vector<float>& ranges_m)
{
    ranges_m.resize(fields.count("num_readings", most_beams));
    for (auto& range_m : ranges_m) range_m = static_cast<float>(fields.number("range"));
}

/// FLASER lines do not tell their angles. The scanners behind them look over half a circle; an even
/// number of beams misses the last one (180: -90 to +89 deg). 101 and 401 beams are the narrow
/// modes of the same scanner, over 100 deg.
void fill_angles_from_count(CarmenScan& scan)
{
    const auto beams = scan.ranges_m.size();
    const double field_rad = beams == 101 || beams == 401 ? pi * 100 / 180 : pi;
    const auto steps = beams % 2 == 0 ? beams : beams - 1;
    scan.first_angle_rad = beams == 1 ? 0 : -field_rad / 2;
    scan.step_rad = steps == 0 ? 0 : field_rad / static_cast<double>(steps);
}

/// MRPT holds whole numbers; each beam needs its own.
void parse_remissions(TextFields& fields, CarmenScan& scan)
{
    const auto count = fields.count("num_remissions", most_beams);
    scan.remissions.clear();
    bool fits = count == scan.ranges_m.size();
    for (std::size_t i = 0; i < count; ++i)
    {
        const double remission = fields.number("remission");
        fits = fits && remission == std::trunc(remission) && std::abs(remission) < 1e9;
        if (fits) scan.remissions.push_back(static_cast<std::int32_t>(remission));
    }
    if (!fits) scan.remissions.clear();
    scan.lost_remissions = fits ? 0 : count;
}

void parse_flaser(TextFields& fields, CarmenScan& scan)
{
    parse_ranges(fields, scan.ranges_m);
    fill_angles_from_count(scan);
    scan.max_range_m = scan.accuracy_m = 0;
    scan.remissions.clear();
    scan.lost_remissions = 0;
    scan.pose_log_laser = parse_pose(fields, "x", "y", "theta");
    scan.pose_odom_vehicle = parse_pose(fields, "odom_x", "odom_y", "odom_theta");
    scan.stamp_100ns = parse_stamp(fields);
}

void parse_robotlaser(TextFields& fields, CarmenScan& scan)
{
    static_cast<void>(fields.word("laser_type"));
    scan.first_angle_rad = fields.finite_number("start_angle");
    static_cast<void>(fields.finite_number("field_of_view"));
    scan.step_rad = fields.finite_number("angular_resolution");
    scan.max_range_m = fields.finite_number("maximum_range");
    scan.accuracy_m = fields.finite_number("accuracy");
    static_cast<void>(fields.word("remission_mode"));
    parse_ranges(fields, scan.ranges_m);
    parse_remissions(fields, scan);
    scan.pose_log_laser = parse_pose(fields, "laser_pose_x", "laser_pose_y", "laser_pose_theta");
    scan.pose_odom_vehicle = parse_pose(fields, "robot_pose_x", "robot_pose_y", "robot_pose_theta");
    for (const char* name :
         {"laser_tv", "laser_rv", "forward_safety_dist", "side_safety_dist", "turn_axis"})
        static_cast<void>(fields.word(name));
    scan.stamp_100ns = parse_stamp(fields);
}
}  // namespace

void parse_scan(TextFields& fields, CarmenScan& scan)
{
    const bool is_short = scan.laser == CarmenLaser::Front || scan.laser == CarmenLaser::Rear;
    is_short ? parse_flaser(fields, scan) : parse_robotlaser(fields, scan);
}

CarmenOdometry parse_odom(TextFields& fields)
{
    CarmenOdometry odometry;
    odometry.pose_odom_vehicle = parse_pose(fields, "x", "y", "theta");
    for (const char* name : {"tv", "rv", "accel"}) static_cast<void>(fields.word(name));
    odometry.stamp_100ns = parse_stamp(fields);
    return odometry;
}

bool laser_of_line(std::string_view line_name, CarmenLaser& laser)
{
    if (line_name == "FLASER")
        laser = CarmenLaser::Front;
    else if (line_name == "RLASER")
        laser = CarmenLaser::Rear;
    else if (line_name == "ROBOTLASER1")
        laser = CarmenLaser::RobotFront;
    else if (line_name == "ROBOTLASER2")
        laser = CarmenLaser::RobotRear;
    else
        return false;
    return true;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "carmen_lines.h"

#include "number_text.h"

namespace rtob
{
namespace
{
void write_all(std::ostream& out, std::initializer_list<double> values)
{
    for (const double value : values) write_exact(out << ' ', value);
}

void write_pose(std::ostream& out, const Pose2& pose)
{
    write_all(out, {pose.x, pose.y, pose.yaw});
}

template <class Number, class Stored>
void write_list(std::ostream& out, const std::vector<Stored>& values)
{
    write_exact(out << ' ', static_cast<std::int64_t>(values.size()));
    for (const auto value : values) write_exact(out << ' ', Number{value});
}
}  // namespace

void write_scan(std::ostream& out, const CarmenScan& scan)
{
    const auto steps = scan.ranges_m.empty() ? 0.0 : static_cast<double>(scan.ranges_m.size()) - 1;
    const int remission_mode = scan.remissions.empty() ? 0 : 1;
    out << (scan.laser == CarmenLaser::RobotRear ? "ROBOTLASER2 0" : "ROBOTLASER1 0");
    write_all(out, {scan.first_angle_rad, scan.step_rad * steps, scan.step_rad});
    for (const double length_m : {scan.max_range_m, scan.accuracy_m})
        write_exact(out << ' ', static_cast<float>(length_m));
    out << ' ' << remission_mode;
    write_list<float>(out, scan.ranges_m);
    write_list<std::int64_t>(out, scan.remissions);
    write_pose(out, scan.pose_log_laser);
    write_pose(out, scan.pose_odom_vehicle);
    out << " 0 0 0 0 0";  // speeds, safety distances and the axis of turning: unknown
}

void write_odom(
    std::ostream& out, const Pose2& pose_odom_vehicle, double speed_mps, double turn_radps)
{
    out << "ODOM";
    write_pose(out, pose_odom_vehicle);
    write_all(out, {speed_mps, turn_radps, 0});
}

void write_stamp(std::ostream& out, std::int64_t stamp_100ns, std::int64_t since_start_100ns)
{
    write_ticks_100ns(out << ' ', stamp_100ns);
    write_ticks_100ns(out << " rtob ", since_start_100ns);
    out << '\n';
}
}  // namespace rtob

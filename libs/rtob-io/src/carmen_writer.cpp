// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/carmen_writer.h>

#include <cmath>
#include <stdexcept>

#include "carmen_lines.h"
#include "flat_scan.h"
#include "motion_pose.h"
#include "mrpt_clock.h"

namespace rtob
{
namespace
{
using namespace mrpt::obs;

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double most_tilt_rad = 1 * degree;  // 1.5 mm in 10 m
constexpr double most_shift_m = 0.001;
constexpr double most_turn_rad = 0.1 * degree;
constexpr std::size_t most_lasers = 2;

std::string quoted_labels(const LogContents& contents)
{
    std::string labels;
    for (const auto& laser : contents.lasers)
        labels += (labels.empty() ? "'" : ", '") + laser.label + "'";
    return labels;
}

void refuse(const std::string& problem, const std::string& fix)
{
    throw std::runtime_error("CARMEN cannot hold this log: " + problem + ". " + fix + ".");
}

void check_lasers(const LogContents& contents)
{
    if (contents.lasers.empty())
        refuse("it has no 2D laser scan", "Name a log with CObservation2DRangeScan entries");
    if (contents.lasers.size() > most_lasers)
        refuse(
            "it has " + std::to_string(contents.lasers.size()) + " lasers (" +
                quoted_labels(contents) + "), and there are names for two",
            "Choose one or two with --lasers LABEL,LABEL");
    for (const auto& laser : contents.lasers)
    {
        const double tilt_rad = flat_mount(laser.pose_vehicle_laser).tilt_rad;
        if (tilt_rad > most_tilt_rad)
            refuse(
                "laser '" + laser.label + "' is tilted by " +
                    std::to_string(std::lround(tilt_rad / degree)) +
                    " degrees, and CARMEN's lasers lie flat",
                "Choose another laser with --lasers, or correct the mount (rawlog-edit "
                "--sensors-pose)");
        if (laser.mount_shift_m > most_shift_m || laser.mount_turn_rad > most_turn_rad)
            refuse(
                "laser '" + laser.label + "' moves on the vehicle",
                "Choose another laser with --lasers");
    }
}

LogContents checked(LogContents contents)
{
    check_lasers(contents);
    if (contents.odometry.size() > 1)
        refuse(
            "it has odometry of " + std::to_string(contents.odometry.size()) + " sensors",
            "Choose one with --poses LABEL");
    return contents;
}

std::string printable(std::string label)
{
    for (char& c : label)
        if (static_cast<unsigned char>(c) < ' ') c = '?';
    return label;
}
}  // namespace

CarmenWriter::CarmenWriter(const std::string& file, LogContents contents)
    : contents_(checked(std::move(contents))), out_(file)
{
    if (contents_.motions == 0 && contents_.first_pose_odom_vehicle)
        pose_odom_vehicle_ = *contents_.first_pose_odom_vehicle;
    writeHeader();
}

void CarmenWriter::writeHeader()
{
    auto& out = out_.stream();
    out << "# CARMEN log, angles in radians, ranges in metres, 0 and maximum_range: no return\n";
    for (std::size_t i = 0; i < contents_.lasers.size(); ++i)
    {
        const auto& laser = contents_.lasers[i];
        out << "# ROBOTLASER" << i + 1 << ": '" << printable(laser.label) << "'\n";
        if (laser.pose_vehicle_laser.z() != 0)
            lose("height of a laser above the vehicle's origin", 1);
        if (flat_mount(laser.pose_vehicle_laser).tilt_rad > 1e-6)
            lose("tilt of a laser, less than a degree", 1);
    }
    if (!contents_.has_odometry())
        out << "# no odometry: all vehicle poses are zero, the laser poses are the mounts\n";
}

void CarmenWriter::write(const LogEntry& entry)
{
    if (entry.motion)
    {
        pose_odom_vehicle_ = compose(pose_odom_vehicle_, pose2_of(*entry.motion));
        odometry_is_known_ = true;
    }
    else if (
        const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(entry.observation.get()))
        writeScan(*scan);
    else if (
        const auto* odometry = dynamic_cast<const CObservationOdometry*>(entry.observation.get()))
        writeOdometry(*odometry);
    else
        lose(
            std::string("observations of class ") +
            entry.observation->GetRuntimeClass()->className);
    out_.check();
}

void CarmenWriter::writeScan(const CObservation2DRangeScan& scan)
{
    LogLosses losses;
    CarmenScan carmen = to_carmen(scan, losses);
    for (const auto& [what, times] : losses) lose(what, times);
    const bool is_first_laser = scan.sensorLabel == contents_.lasers.front().label;
    carmen.laser = is_first_laser ? CarmenLaser::RobotFront : CarmenLaser::RobotRear;
    carmen.pose_odom_vehicle = pose_odom_vehicle_;
    carmen.pose_log_laser =
        compose(pose_odom_vehicle_, flat_mount(scan.sensorPose).pose_vehicle_laser);
    if (contents_.first_pose_odom_vehicle && !odometry_is_known_)
        lose("scans before the first odometry: they carry that");
    write_scan(out_.stream(), carmen);
    writeEnd(stampOf(scan));
}

void CarmenWriter::writeOdometry(const CObservationOdometry& odometry)
{
    pose_odom_vehicle_ = pose2_of(odometry.odometry);
    odometry_is_known_ = true;
    const auto& speed = odometry.velocityLocal;
    const bool has_speed = odometry.hasVelocities;
    if (has_speed && speed.vy != 0) lose("sideways speeds of the odometry");
    if (odometry.hasEncodersInfo) lose("wheel encoder readings of the odometry");
    write_odom(
        out_.stream(), pose_odom_vehicle_, has_speed ? speed.vx : 0, has_speed ? speed.omega : 0);
    writeEnd(stampOf(odometry));
}

void CarmenWriter::writeEnd(std::int64_t stamp_100ns)
{
    if (!first_stamp_100ns_) first_stamp_100ns_ = stamp_100ns;
    write_stamp(out_.stream(), stamp_100ns, stamp_100ns - *first_stamp_100ns_);
}

std::int64_t CarmenWriter::stampOf(const CObservation& observation)
{
    if (observation.timestamp == INVALID_TIMESTAMP)
        lose("entries without a stamp: they repeat the one before");
    else
        last_stamp_100ns_ = unix_100ns_of(observation.timestamp);
    return last_stamp_100ns_;
}
}  // namespace rtob

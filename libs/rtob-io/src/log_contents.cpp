// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <rtob/io/log_contents.h>

#include <algorithm>
#include <cmath>

#include "motion_pose.h"

namespace rtob
{
namespace
{
using namespace mrpt::obs;

LaserContents& laser_of(LogContents& contents, const CObservation2DRangeScan& scan)
{
    for (auto& laser : contents.lasers)
        if (laser.label == scan.sensorLabel) return laser;
    auto& laser = contents.lasers.emplace_back();
    laser.label = scan.sensorLabel;
    laser.pose_vehicle_laser = scan.sensorPose;
    return laser;
}

/// The angle of the rotation that leads from one attitude to the other.
double turn_between_rad(const mrpt::poses::CPose3D& a, const mrpt::poses::CPose3D& b)
{
    double trace = 0;  // of the transpose of a's rotation times b's
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            trace += a.getRotationMatrix()(row, column) * b.getRotationMatrix()(row, column);
    return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0));
}

void take_scan(LogContents& contents, const CObservation2DRangeScan& scan)
{
    auto& laser = laser_of(contents, scan);
    const auto& mount = laser.pose_vehicle_laser;
    ++laser.scans;
    laser.mount_shift_m = std::max(
        laser.mount_shift_m,
        mount.distance3DTo(scan.sensorPose.x(), scan.sensorPose.y(), scan.sensorPose.z()));
    laser.mount_turn_rad = std::max(laser.mount_turn_rad, turn_between_rad(mount, scan.sensorPose));
    if (lacks_max_range(scan)) laser.no_return.add(scan);
}

void take_observation(LogContents& contents, const CObservation& observation)
{
    if (const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(&observation))
        take_scan(contents, *scan);
    else if (const auto* odometry = dynamic_cast<const CObservationOdometry*>(&observation))
    {
        ++contents.odometry[observation.sensorLabel];
        if (!contents.first_pose_odom_vehicle)
            contents.first_pose_odom_vehicle = pose2_of(odometry->odometry);
    }
    else if (dynamic_cast<const CObservationRobotPose*>(&observation) != nullptr)
        ++contents.robot_poses[observation.sensorLabel];
    else
        ++contents.others[observation.GetRuntimeClass()->className];
}
}  // namespace

LogContents survey_log(LogReader& log)
{
    LogContents contents;
    try
    {
        while (const auto entry = log.next())
            if (entry->motion)
                ++contents.motions;
            else
                take_observation(contents, *entry->observation);
    }
    catch (const LogError& error)
    {
        contents.damage = error.what();
    }
    return contents;
}
}  // namespace rtob

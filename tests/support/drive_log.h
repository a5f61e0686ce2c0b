// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CSerializable.h>

#include <vector>

#include "room_mrpt.h"

/// Logs of a vehicle that drives through room_4x3(), ten scans a second.
namespace rtob::test
{
using LogObjects = std::vector<mrpt::serialization::CSerializable::Ptr>;

constexpr double drive_start_s = 1000.25;
constexpr double drive_step_s = 0.1;

/// On a circle of 0.5 m around (1.5, 1.2), 5 cm and 5.7 degrees a scan.
[[nodiscard]] inline Pose2 pose_on_circle(int scan)
{
    const double angle_rad = 0.1 * scan;
    constexpr double pi = 3.14159265358979323846;
    return {
        1.5 + 0.5 * std::cos(angle_rad), 1.2 + 0.5 * std::sin(angle_rad),
        wrap_angle(angle_rad + pi / 2)};
}

[[nodiscard]] inline mrpt::obs::CObservation2DRangeScan::Ptr scan_on_circle(
    int scan, const Room& room = room_4x3())
{
    return mrpt::obs::CObservation2DRangeScan::Create(scan_observation(
        room, pose_on_circle(scan), drive_start_s + scan * drive_step_s, mrpt_laser()));
}

[[nodiscard]] inline mrpt::obs::CObservationOdometry::Ptr odometry_on_circle(int scan)
{
    auto odometry = mrpt::obs::CObservationOdometry::Create();
    odometry->timestamp = mrpt::Clock::fromDouble(drive_start_s + scan * drive_step_s - 0.01);
    const Pose2 pose = pose_on_circle(scan);
    odometry->odometry = mrpt::poses::CPose2D(pose.x, pose.y, pose.yaw);
    return odometry;
}

/// Odometry and scan in turn.
[[nodiscard]] inline LogObjects drive_objects(int scans)
{
    LogObjects objects;
    for (int k = 0; k < scans; ++k)
    {
        objects.push_back(odometry_on_circle(k));
        objects.push_back(scan_on_circle(k));
    }
    return objects;
}

/// Where the drive goes as seen from its first pose: the map's frame.
[[nodiscard]] inline Pose2 pose_on_circle_map(int scan)
{
    return between(pose_on_circle(0), pose_on_circle(scan));
}

/// A scan whose beams all have this range and validity.
[[nodiscard]] inline mrpt::obs::CObservation2DRangeScan::Ptr scan_of(
    std::size_t beams, float range_m, bool valid, double stamp_s)
{
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    scan->timestamp = mrpt::Clock::fromDouble(stamp_s);
    scan->sensorLabel = "LASER";
    scan->resizeScan(beams);
    for (std::size_t i = 0; i < beams; ++i)
    {
        scan->setScanRange(i, range_m);
        scan->setScanRangeValidity(i, valid);
    }
    return scan;
}
}  // namespace rtob::test

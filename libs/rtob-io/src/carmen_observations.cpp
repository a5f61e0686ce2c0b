// SPDX-License-Identifier: BSD-3-Clause
#include "carmen_observations.h"

#include "mrpt_clock.h"

namespace rtob
{
namespace
{
const char* label_of(CarmenLaser laser)
{
    const bool rear = laser == CarmenLaser::Rear || laser == CarmenLaser::RobotRear;
    return rear ? "laser_rear" : "laser_front";
}
}  // namespace

mrpt::obs::CObservation2DRangeScan::Ptr to_observation(
    const CarmenScan& scan, const Pose2& pose_vehicle_laser)
{
    auto observation = mrpt::obs::CObservation2DRangeScan::Create();
    observation->timestamp = clock_of(scan.stamp_100ns);
    observation->sensorLabel = label_of(scan.laser);

    const auto beams = scan.ranges_m.size();
    const double field_rad = beams > 1 ? scan.step_rad * static_cast<double>(beams - 1) : 0;
    const Pose2 pose_laser_middle{0, 0, scan.first_angle_rad + field_rad / 2};
    const Pose2 pose_vehicle_middle = compose(pose_vehicle_laser, pose_laser_middle);
    observation->aperture = static_cast<float>(std::abs(field_rad));
    observation->rightToLeft = field_rad >= 0;
    observation->sensorPose = mrpt::poses::CPose3D(
        pose_vehicle_middle.x, pose_vehicle_middle.y, 0, pose_vehicle_middle.yaw, 0, 0);

    const bool told = scan.max_range_m > 0;
    observation->maxRange = told ? static_cast<float>(scan.max_range_m) : max_range_when_untold_m;
    std::vector<char> valid(beams);
    for (std::size_t i = 0; i < beams; ++i)
        valid[i] = scan.ranges_m[i] > 0 && scan.ranges_m[i] < observation->maxRange;
    // MRPT asserts on the null pointer of an empty vector.
    if (beams > 0) observation->loadFromVectors(beams, scan.ranges_m.data(), valid.data());
    if (scan.accuracy_m > 0) observation->stdError = static_cast<float>(scan.accuracy_m);
    if (scan.remissions.empty()) return observation;
    observation->setScanHasIntensity(true);
    for (std::size_t i = 0; i < beams; ++i) observation->setScanIntensity(i, scan.remissions[i]);
    return observation;
}

mrpt::obs::CObservationOdometry::Ptr to_observation(const CarmenOdometry& odometry)
{
    auto observation = mrpt::obs::CObservationOdometry::Create();
    observation->timestamp = clock_of(odometry.stamp_100ns);
    observation->sensorLabel = "odometry";
    const Pose2& pose = odometry.pose_odom_vehicle;
    observation->odometry = mrpt::poses::CPose2D(pose.x, pose.y, pose.yaw);
    return observation;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationRange.h>
#include <mrpt/poses/CPose3D.h>
#include <rtob/slam/motion_readings.h>

#include <cmath>

namespace rtob
{
namespace
{
using namespace mrpt::obs;

double value_or_zero(const CObservationIMU& imu, TIMUDataIndex index)
{
    return imu.has(index) ? imu.get(index) : 0.0;
}
}  // namespace

std::optional<double> yaw_rate_in(const CObservation& observation)
{
    const auto* imu = dynamic_cast<const CObservationIMU*>(&observation);
    if (imu == nullptr || !imu->has(IMU_WZ)) return std::nullopt;
    const auto& rotation = imu->sensorPose.getRotationMatrix();
    return rotation(2, 0) * value_or_zero(*imu, IMU_WX) +
           rotation(2, 1) * value_or_zero(*imu, IMU_WY) + rotation(2, 2) * imu->get(IMU_WZ);
}

std::optional<Eigen::Vector2d> flow_in(const CObservation& observation)
{
    const auto* imu = dynamic_cast<const CObservationIMU*>(&observation);
    if (imu == nullptr || !imu->has(IMU_X_VEL) || !imu->has(IMU_Y_VEL) || imu->has(IMU_X_ACC) ||
        imu->has(IMU_ROLL) || imu->has(IMU_ORI_QUAT_W))
        return std::nullopt;
    return Eigen::Vector2d(imu->get(IMU_X_VEL), imu->get(IMU_Y_VEL));
}

std::optional<Tilt> tilt_in(const CObservation& observation)
{
    const auto* imu = dynamic_cast<const CObservationIMU*>(&observation);
    if (imu == nullptr || !imu->has(IMU_ROLL) || !imu->has(IMU_PITCH)) return std::nullopt;
    // The sensor's attitude is the vehicle's, turned by the mount; a yaw before both changes no
    // tilt.
    const mrpt::poses::CPose3D attitude_sensor(0, 0, 0, 0, imu->get(IMU_PITCH), imu->get(IMU_ROLL));
    const auto& mount = imu->sensorPose;
    const mrpt::poses::CPose3D turn_vehicle_sensor(
        0, 0, 0, mount.yaw(), mount.pitch(), mount.roll());
    const mrpt::poses::CPose3D attitude_vehicle = attitude_sensor + -turn_vehicle_sensor;
    return Tilt{attitude_vehicle.roll(), attitude_vehicle.pitch()};
}

std::optional<double> height_in(const CObservation& observation)
{
    if (const auto* imu = dynamic_cast<const CObservationIMU*>(&observation))
        return imu->has(IMU_ALTITUDE) ? std::optional(imu->get(IMU_ALTITUDE)) : std::nullopt;
    const auto* range = dynamic_cast<const CObservationRange*>(&observation);
    if (range == nullptr) return std::nullopt;
    constexpr double straight_down_rad = M_PI / 2, tolerance_rad = 0.2;
    for (const auto& measurement : range->sensedData)
        if (std::abs(measurement.sensorPose.pitch - straight_down_rad) < tolerance_rad)
            return measurement.sensedDistance - measurement.sensorPose.z;
    return std::nullopt;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation.h>
#include <Eigen/Core>

#include <optional>

/// What MRPT's observations tell of a vehicle's motion, in the vehicle's axes: x ahead, y left, z
/// up. Values are as the sensor gave them, NaN included.
namespace rtob
{
struct Tilt
{
    double roll_rad = 0;   ///< right side down
    double pitch_rad = 0;  ///< nose down
};

/// CObservationIMU's angular velocity about the vehicle's z axis; the mount may be any.
[[nodiscard]] std::optional<double> yaw_rate_in(const mrpt::obs::CObservation& observation);

/// Optical flow: CObservationIMU's IMU_X_VEL and IMU_Y_VEL, where it holds neither acceleration nor
/// orientation. Inertial systems, which do, mean the map's axes by them.
[[nodiscard]] std::optional<Eigen::Vector2d> flow_in(const mrpt::obs::CObservation& observation);

[[nodiscard]] std::optional<Tilt> tilt_in(const mrpt::obs::CObservation& observation);

/// Of the vehicle's origin above the floor: IMU_ALTITUDE, or a CObservationRange that looks down.
[[nodiscard]] std::optional<double> height_in(const mrpt::obs::CObservation& observation);
}  // namespace rtob

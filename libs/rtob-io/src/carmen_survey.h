// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <array>
#include <string>

#include "carmen_message.h"

namespace rtob
{
/// What must be known of a CARMEN log before its first line can be understood.
struct CarmenSurvey
{
    std::array<Pose2, carmen_laser_count> poses_vehicle_laser;  ///< by CarmenLaser
    /// The laser lines carry odometry: it is interpolated to the scan, while ODOM lines lie at
    /// other times and, in corrected logs, in another frame. Mixing both would make it jump.
    bool lasers_carry_odometry = false;
    /// The laser's pose is not in the odometry's frame: somebody corrected it.
    bool is_corrected = false;
};

/// Reads ahead until the vehicle has moved far enough to tell, mostly a few seconds of driving.
/// A mount comes from PARAM robot_frontlaser_offset and robot_rearlaser_offset; without them from
/// the laser's pose seen from the odometry, if that stays the same while the vehicle moves (in
/// corrected logs it does not: the one is in map, the other in odom). A damaged line ends the
/// survey: the reader proper will report it.
[[nodiscard]] CarmenSurvey survey_carmen_log(const std::string& file);
}  // namespace rtob

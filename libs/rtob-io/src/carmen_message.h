// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "text_fields.h"

namespace rtob
{
/// Which laser of the vehicle a line speaks of.
enum class CarmenLaser
{
    Front,       ///< FLASER
    Rear,        ///< RLASER
    RobotFront,  ///< ROBOTLASER1
    RobotRear    ///< ROBOTLASER2
};
constexpr std::size_t carmen_laser_count = 4;

/// A laser line as it stands in the log. Beams run counter-clockwise.
struct CarmenScan
{
    CarmenLaser laser = CarmenLaser::Front;
    std::vector<float> ranges_m;
    double first_angle_rad = 0;  ///< of beam 0, in the laser's frame
    double step_rad = 0;
    std::vector<std::int32_t> remissions;  ///< one a beam, or none
    std::size_t lost_remissions = 0;       ///< that are not whole numbers, or not one a beam
    double max_range_m = 0;                ///< 0 where the line does not tell
    double accuracy_m = 0;                 ///< likewise
    Pose2 pose_log_laser;                  ///< "log" is odom in raw logs, map in corrected ones
    Pose2 pose_odom_vehicle;
    std::int64_t stamp_100ns = 0;  ///< since 1970
};

struct CarmenOdometry
{
    Pose2 pose_odom_vehicle;
    std::int64_t stamp_100ns = 0;
};

/// Each takes the fields after the line's name; throws FieldError. The stamp is the line's first
/// (ipc_timestamp): published relations name scans by it, the logger's own stamp is another clock.
void parse_scan(TextFields& fields, CarmenScan& scan);  ///< in the format of scan.laser's lines
[[nodiscard]] CarmenOdometry parse_odom(TextFields& fields);

/// The laser that a line's name stands for; false for any other line.
[[nodiscard]] bool laser_of_line(std::string_view line_name, CarmenLaser& laser);
}  // namespace rtob

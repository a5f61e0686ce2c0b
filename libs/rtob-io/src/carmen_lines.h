// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ostream>

#include "carmen_message.h"

namespace rtob
{
/// The beginning of a laser's or odometry's line, up to the stamp; every number reads back the
/// same.
void write_scan(std::ostream& out, const CarmenScan& scan);
void write_odom(
    std::ostream& out, const Pose2& pose_odom_vehicle, double speed_mps, double turn_radps);

/// The rest of a line. The logger's own clock starts with the log.
void write_stamp(std::ostream& out, std::int64_t stamp_100ns, std::int64_t since_start_100ns);
}  // namespace rtob

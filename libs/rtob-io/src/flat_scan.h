// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/io/log_reader.h>

#include "carmen_message.h"

namespace rtob
{
/// A laser's mount seen from above.
struct FlatMount
{
    Pose2 pose_vehicle_laser;
    bool hangs = false;   ///< upside down: its left is the vehicle's right
    double tilt_rad = 0;  ///< of its plane against the vehicle's
};
[[nodiscard]] FlatMount flat_mount(const mrpt::poses::CPose3D& pose_vehicle_laser);

/// The scan as CARMEN has it, without its poses and stamp: to_observation() gives the same rays
/// again. Counts in `losses` what it cannot hold.
[[nodiscard]] CarmenScan to_carmen(
    const mrpt::obs::CObservation2DRangeScan& scan, LogLosses& losses);
}  // namespace rtob

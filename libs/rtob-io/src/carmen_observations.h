// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>

#include "carmen_message.h"

namespace rtob
{
/// maxRange of scans whose log does not tell it.
constexpr float max_range_when_untold_m = 1000.0F;

/// The scan as MRPT has it. MRPT's beams lie symmetric about the sensor's x axis, so the middle of
/// the field goes into the sensor's yaw. Invalid: ranges that are NaN, zero, negative or, where
/// the log has a maximum range, not below it. The "no return" of FLASER logs is a large number
/// that differs from scanner to scanner (51.1, 81.83, 81.91 m) and stays: the useful range of the
/// scan filter drops it.
[[nodiscard]] mrpt::obs::CObservation2DRangeScan::Ptr to_observation(
    const CarmenScan& scan, const Pose2& pose_vehicle_laser);

[[nodiscard]] mrpt::obs::CObservationOdometry::Ptr to_observation(const CarmenOdometry& odometry);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRange.h>
#include <rtob/sim/laser.h>
#include <rtob/sim/motion_sensors.h>

namespace rtob
{
/// The simulator's time 0 in UNIX time: a round number, the same for every log.
constexpr double kSimulationEpoch_s = 1.6e9;

/// What the simulator measured, as MRPT's classes hold it.
[[nodiscard]] mrpt::obs::CObservation2DRangeScan::Ptr observation_of(
    const sim::LaserScan& scan, const sim::LaserOptions& laser);
[[nodiscard]] mrpt::obs::CObservationIMU::Ptr observation_of(const sim::ImuReading& reading);
[[nodiscard]] mrpt::obs::CObservationOdometry::Ptr observation_of(
    const sim::OdometryReading& reading);
/// MRPT has no class for optical flow: its velocities go into an IMU's, labelled FLOW.
[[nodiscard]] mrpt::obs::CObservationIMU::Ptr observation_of(const sim::FlowReading& reading);
/// A range that looks down.
[[nodiscard]] mrpt::obs::CObservationRange::Ptr observation_of(
    const sim::AltimeterReading& reading);
}  // namespace rtob

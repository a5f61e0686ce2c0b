// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cmath>
#include <string>

#include "log_files.h"

namespace rtob::test
{
/// What a scan says of the world: as many beams in the same directions, the same ranges bit by bit,
/// the same validity, the same place of the laser and the same stamp. Empty if so.
[[nodiscard]] inline std::string difference(
    const mrpt::obs::CObservation2DRangeScan& a, const mrpt::obs::CObservation2DRangeScan& b)
{
    constexpr double angle_step_rad = 1e-6;  // MRPT's float aperture over half a turn
    constexpr double mount_m = 1e-9;         // doubles, some metres from the origin
    if (a.getScanSize() != b.getScanSize()) return "number of beams";
    if (a.timestamp != b.timestamp) return "stamp";
    if (std::abs(a.sensorPose.x() - b.sensorPose.x()) > mount_m ||
        std::abs(a.sensorPose.y() - b.sensorPose.y()) > mount_m)
        return "mount";
    for (std::size_t i = 0; i < a.getScanSize(); ++i)
    {
        const std::string beam = " of beam " + std::to_string(i);
        if (a.getScanRange(i) != b.getScanRange(i)) return "range" + beam;
        if (a.getScanRangeValidity(i) != b.getScanRangeValidity(i)) return "validity" + beam;
        const double turn_rad = std::remainder(
            beam_angle_vehicle(a, i) - beam_angle_vehicle(b, i), 2 * 3.14159265358979323846);
        if (std::abs(turn_rad) > angle_step_rad) return "angle" + beam;
    }
    return {};
}
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <cstddef>

namespace rtob
{
/// One revolution of a laser as the guard takes it. Its times are on the clock of the decisions.
struct GuardScan
{
    double stamp_s = 0;  ///< of the first beam
    double sweep_s = 0;  ///< from the first to the last beam; 0: all at once
    double first_bearing_rad = 0;
    double step_rad = 0;              ///< to the next beam; negative for a clockwise laser
    const float* ranges_m = nullptr;  ///< 0, less or NaN: no return; owned by someone else
    std::size_t beams = 0;
    double max_range_m = 6;  ///< from here on a range says that all before it is free
    Pose2 pose_vehicle_laser;

    [[nodiscard]] double end_s() const { return stamp_s + sweep_s; }
};
}  // namespace rtob

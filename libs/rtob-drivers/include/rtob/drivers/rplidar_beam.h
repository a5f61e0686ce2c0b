// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

namespace rtob
{
/// One measurement. Bearings are the device's: degrees, clockwise from its front, seen from above.
struct RplidarBeam
{
    double bearing_deg = 0;  ///< of the ray, in [0, 360)
    double shaft_deg = 0;    ///< of the turning head when the beam was taken; grows steadily
    float range_m = 0;       ///< 0: nothing seen
    bool starts = false;     ///< the first of a revolution
    double time_s = 0;       ///< when it was taken
};

/// All beams of one turn of the head, in the order in which they were taken.
struct RplidarRevolution
{
    std::vector<RplidarBeam> beams;
    double start_s = 0;  ///< when the first beam was taken
    double sweep_s = 0;  ///< from the first beam to the first one of the next revolution
};
}  // namespace rtob

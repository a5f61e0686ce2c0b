// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/range_source.h>

#include <vector>

namespace rtob::devices
{
/// A scan of a log, as the device saw it.
struct RecordedScan
{
    double time_s = 0;
    double first_rad = 0, step_rad = 0;  ///< bearings, counter-clockwise from the device's front
    std::vector<float> ranges_m;         ///< 0: nothing
};

/// Lets an emulated device see what another one saw: each scan from its own time on, in a direction
/// its nearest beam. Before `begin_s` (UNIX seconds) the first scan, from the log's end on the
/// last. Throws std::invalid_argument without scans.
[[nodiscard]] RangeSource play_scans(std::vector<RecordedScan> scans, double begin_s);
}  // namespace rtob::devices

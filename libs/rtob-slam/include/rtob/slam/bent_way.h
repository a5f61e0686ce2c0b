// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <rtob/core/scan_table.h>
#include <rtob/slam/travel_log.h>

#include <cstddef>
#include <vector>

namespace rtob
{
/// Where the scans of a loop belong once its end turns out to be elsewhere. The error has grown
/// along the way, so each scan takes its share of it: the way is turned a little at each step, and
/// what is then missing to the end is added in proportion to the way. The first scan stays.
///
/// For small turns this is what a pose graph of one loop and equally good steps comes to.
/// @param first the first scan of the way, one of the table; the last is the table's last.
/// @param end where the way led, @param end_now where that is in truth, both in map.
/// @param poses [out] one for each scan from `first` on, in map.
void bend_way(
    const ScanTable& scans, const TravelLog& travel, std::size_t first, const Pose2& end,
    const Pose2& end_now, std::vector<Pose2>& poses);
}  // namespace rtob

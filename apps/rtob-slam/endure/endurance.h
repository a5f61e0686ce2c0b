// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/slam/slam_options.h>

#include <cstdint>
#include <functional>
#include <string>

namespace rtob
{
struct EnduranceJob
{
    std::string world;  ///< a world file
    std::uint64_t scans = 36'000, every_scans = 3600, seed = 1;
    SlamOptions slam;
};

/// One block of scans of a flight without an end.
struct EnduranceBlock
{
    std::uint64_t scans = 0;  ///< since the start
    std::size_t map_scans = 0, map_points = 0;
    double memory_mb = 0;  ///< of the process, now
    double scan_p50_ms = 0, scan_p99_ms = 0, scan_max_ms = 0;
    double error_max_m = 0;  ///< of the pose
    std::uint64_t not_tracking = 0;
};

/// Flies the world again and again without a log, and tells of each block of scans.
void endure(const EnduranceJob& job, const std::function<void(const EnduranceBlock&)>& done);

/// A table's line for a block, and the line above them.
[[nodiscard]] std::string endurance_header();
[[nodiscard]] std::string endurance_line(const EnduranceBlock& block);
}  // namespace rtob

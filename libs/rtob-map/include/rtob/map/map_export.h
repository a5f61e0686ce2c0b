// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/maps/CPointsMap.h>
#include <rtob/core/scan_table.h>

#include <string>

/// Files that other programs read. Each function throws std::runtime_error naming the file when it
/// cannot be written.
namespace rtob
{
/// ASCII Stanford PLY.
void save_ply(const mrpt::maps::CPointsMap& points_map, const std::string& file);
/// ASCII PCD 0.7 of the Point Cloud Library.
void save_pcd(const mrpt::maps::CPointsMap& points_map, const std::string& file);
/// A line "x y z" for each point.
void save_points_text(const mrpt::maps::CPointsMap& points_map, const std::string& file);
/// A line "time_s x y yaw points" for each scan, after a comment line that says so.
void save_scans_text(const ScanTable& scans, const std::string& file);
}  // namespace rtob

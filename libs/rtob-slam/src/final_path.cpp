// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/final_path.h>

#include <cmath>

#include "scan_cursor.h"

namespace rtob
{
void FinalPath::add(const ScanReport& report)
{
    const double stamp_s = std::isfinite(report.stamp_s) ? report.stamp_s : 0;
    told_.push_back({{stamp_s, report.pose_map_vehicle}, report.map_time_s, report.inserted});
}

std::vector<StampedPose2> FinalPath::in(const ScanTable& scans) const
{
    std::vector<StampedPose2> path;
    path.reserve(told_.size());
    ScanCursor written(scans);
    Pose2 pose_final_told;  // how the map has moved what was told
    for (const Told& told : told_)
    {
        const Pose2& pose = told.stamped.pose;
        const auto scan = told.inserted ? written.find(told.map_time_s) : std::nullopt;
        if (scan) pose_final_told = compose(scans.pose(*scan), inverse(pose));
        path.push_back({told.stamped.time_s, compose(pose_final_told, pose)});
    }
    return path;
}
}  // namespace rtob

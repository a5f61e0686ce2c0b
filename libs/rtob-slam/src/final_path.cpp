// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/final_path.h>

#include <cmath>

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
    Pose2 pose_final_told;  // how the map has moved what was told
    for (const Told& told : told_)
    {
        const Pose2& pose = told.stamped.pose;
        const std::size_t scan =
            told.inserted ? scans.firstScanSince(told.map_time_s) : scans.size();
        if (scan < scans.size() && scans.time(scan) == told.map_time_s)
            pose_final_told = compose(scans.pose(scan), inverse(pose));
        path.push_back({told.stamped.time_s, compose(pose_final_told, pose)});
    }
    return path;
}
}  // namespace rtob

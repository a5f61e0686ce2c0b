// SPDX-License-Identifier: BSD-3-Clause
#include "run/scan_mounts.h"

#include "run/run_counters.h"

namespace rtob
{
namespace
{
bool is_same(const Pose2& a, const Pose2& b)
{
    return a.x == b.x && a.y == b.y && a.yaw == b.yaw;
}
}  // namespace

void ScanMounts::add(const ScanReport& report, const Pose2& pose_vehicle_laser)
{
    if (!has_first_) first_ = pose_vehicle_laser;
    has_first_ = true;
    if (!report.inserted) return;
    if (fate_of(report) == ScanFate::Started) mounts_.clear();
    if (mounts_.empty() || !is_same(mounts_.back().pose_vehicle_laser, pose_vehicle_laser))
        mounts_.push_back({report.map_time_s, pose_vehicle_laser});
}

std::vector<Pose2> ScanMounts::of(const ScanTable& scans) const
{
    std::vector<Pose2> mounts;
    mounts.reserve(scans.size());
    auto next = mounts_.begin();
    Pose2 mount = first_;
    for (std::size_t k = 0; k < scans.size(); ++k)
    {
        for (; next != mounts_.end() && next->since_s <= scans.time(k); ++next)
            mount = next->pose_vehicle_laser;
        mounts.push_back(mount);
    }
    return mounts;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/scan_table.h>
#include <rtob/slam/scan_report.h>

#include <vector>

namespace rtob
{
/// Where on the vehicle the laser was behind each scan of a map. One laser takes no memory to speak
/// of, however long it runs.
class ScanMounts
{
 public:
    /// To be called for each scan of the log.
    void add(const ScanReport& report, const Pose2& pose_vehicle_laser);

    /// For each scan of the map. Scans of an earlier run are taken to come from this run's first
    /// laser.
    [[nodiscard]] std::vector<Pose2> of(const ScanTable& scans) const;

 private:
    struct Mount
    {
        double since_s;  ///< map time
        Pose2 pose_vehicle_laser;
    };
    Pose2 first_;
    bool has_first_ = false;
    std::vector<Mount> mounts_;  ///< of scans that were written, where it changed
};
}  // namespace rtob

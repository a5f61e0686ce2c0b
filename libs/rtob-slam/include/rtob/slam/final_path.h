// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <rtob/core/scan_table.h>
#include <rtob/slam/scan_report.h>

#include <cstddef>
#include <vector>

namespace rtob
{
/// The path of a run as its map has it in the end. The poses that a run tells are never changed
/// later; the map's scans are, when a loop is closed, and a scan that is not in the map goes with
/// the one written before it. For whoever works on a log afterwards.
class FinalPath
{
 public:
    void add(const ScanReport& report);

    /// @param scans of the map, in the end.
    /// @return a pose for each scan added, in map, with the stamps of the log, 0 for
    /// one that is no number. Scans that the map has
    /// forgotten go with the last one that it has not.
    [[nodiscard]] std::vector<StampedPose2> in(const ScanTable& scans) const;

 private:
    struct Told
    {
        StampedPose2 stamped;
        double map_time_s;
        bool inserted;
    };
    std::vector<Told> told_;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/slam/scan_report.h>

namespace rtob
{
/// Collects the scans that joined the map as MRPT's CSimpleMap: poses with their observations. It
/// keeps all of them in memory, as its reader does.
class SimpleMapRecorder
{
 public:
    /// @param pose_vehicle_laser replaces the scan's own mount.
    void add(
        const mrpt::obs::CObservation2DRangeScan& scan,
        const mrpt::poses::CPose3D& pose_vehicle_laser, const ScanReport& report);

    [[nodiscard]] const mrpt::maps::CSimpleMap& map() const { return map_; }

 private:
    mrpt::maps::CSimpleMap map_;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation.h>
#include <rtob/core/scan_table.h>
#include <rtob/slam/scan_report.h>
#include <Eigen/Core>

#include <vector>

namespace rtob
{
/// Keeps the scans that were written into a map, for programs that want MRPT's CSimpleMap: poses
/// with their observations. Memory grows with the drive, as that of its readers does.
class WrittenScans
{
 public:
    /// Keeps the scan if the report says that it was written.
    void add(const mrpt::obs::CObservation::Ptr& scan, const ScanReport& report);
    void clear() { written_.clear(); }

    /// @param scans of the map.
    /// @return those scans that are still in the map, where they are now: a frame each.
    [[nodiscard]] mrpt::maps::CSimpleMap in(const ScanTable& scans) const;

 private:
    struct Written
    {
        double map_time_s;
        mrpt::obs::CObservation::Ptr scan;
        Eigen::Matrix3d covariance;  ///< of x, y, yaw, in m^2 and rad^2
    };
    std::vector<Written> written_;
};
}  // namespace rtob

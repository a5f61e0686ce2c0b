// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>

#include <string>

namespace rtob
{
/// Whether a scan can follow the last one that was tracked: a vehicle that drives or turns sees
/// much of the same again, one that was carried away does not, however well the new scan may fit
/// some part of the map. Keeps buffers only.
class Continuity
{
 public:
    explicit Continuity(const IcpOptions& icp);

    /// The scan was taken here.
    void tracked(
        const std::string& laser, const Pose2& pose_map_vehicle, const Points& points_vehicle);
    void clear() { laser_.clear(); }

    /// [0, 1] of the scan's points that agree with the last scan tracked, where it has any near;
    /// less where they stand in what it saw free; 1 where there is no scan of this laser to compare
    /// with.
    [[nodiscard]] double agreement(
        const std::string& laser, const Pose2& pose_map_vehicle, const Points& points_vehicle);

 private:
    Icp icp_;
    IcpReference reference_;
    std::string laser_;
    Pose2 tracked_at_;  ///< in map
    Points tracked_vehicle_, points_turned_;
};
}  // namespace rtob

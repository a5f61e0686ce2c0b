// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <cstddef>
#include <vector>

namespace rtob
{
/// How far the vehicle had travelled when each scan of the map was taken: tells scans of this visit
/// from scans of an earlier one. 4 bytes a scan.
class TravelLog
{
 public:
    /// To be called for each scan of the map, with its pose.
    void inserted(const Pose2& pose_map_vehicle);

    [[nodiscard]] double path() const { return path_m_.empty() ? 0.0 : path_m_.back(); }

    /// How many scans of the map were taken before the last `travel_m` of travel.
    [[nodiscard]] std::size_t scansBefore(double travel_m) const;

 private:
    std::vector<float> path_m_;
    Pose2 last_pose_;
};
}  // namespace rtob

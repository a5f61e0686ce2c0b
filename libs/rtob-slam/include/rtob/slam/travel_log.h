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

    /// The newest scan was moved here: the next step sets off from it.
    void moved(const Pose2& pose_map_vehicle) { last_pose_ = pose_map_vehicle; }

    /// The map forgets scans, and the way to its newest if they go. @param keep one entry a scan: 0
    /// to forget it.
    void keepOnly(const std::vector<char>& keep);
    void reserve(std::size_t scans) { path_m_.reserve(scans); }

    [[nodiscard]] double path() const
    {
        return path_m_.empty() ? before_m_ : before_m_ + path_m_.back();
    }

    /// Travel up to a scan of the map.
    [[nodiscard]] double pathAt(std::size_t scan) const { return before_m_ + path_m_[scan]; }

    /// How many scans of the map were taken before the last `travel_m` of travel.
    [[nodiscard]] std::size_t scansBefore(double travel_m) const;

 private:
    std::vector<float> path_m_;  ///< without what is in before_m_
    double before_m_ = 0;        ///< keeps the others small, so that a float holds them
    Pose2 last_pose_;
};
}  // namespace rtob

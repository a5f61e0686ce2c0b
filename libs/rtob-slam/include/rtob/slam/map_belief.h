// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/reference_draw.h>

#include <Eigen/Core>
#include <array>
#include <vector>

namespace rtob
{
/// How far off the scans of a map may be: of each, what was believed of the pose with which it was
/// written. Who finds his place by old scans knows it no better than these know theirs. 24 bytes a
/// scan.
class MapBelief
{
 public:
    MapBelief();

    /// To be called for each scan of the map. @param covariance of its pose in the map
    void inserted(const Eigen::Matrix3d& covariance);
    /// The map forgets scans. @param keep one entry a scan: 0 to forget it.
    void keepOnly(const std::vector<char>& keep);
    void reserve(std::size_t scans) { of_scan_.reserve(scans); }
    void clear() { of_scan_.clear(); }

    /// The mean covariance of the map's first `end` scans, of those that were taken near this
    /// place; zero where there are none.
    [[nodiscard]] Eigen::Matrix3d near(const MapView& map, const Pose2& pose_map, std::size_t end);

 private:
    using Packed = std::array<float, 6>;  ///< xx, xy, yy, x yaw, y yaw, yaw yaw

    static constexpr std::size_t kMostVisits = 16;

    std::vector<Packed> of_scan_;
    std::vector<ScanRange> visits_;  ///< buffer
};
}  // namespace rtob

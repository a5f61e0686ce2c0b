// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/scan_picture.h>

#include <cstddef>
#include <vector>

namespace rtob
{
/// Obstacles that earlier scans have seen and the newest one does not show, in map, oldest first.
/// What a scan shows needs no memory: all remembered points in its view make way for it.
class ObstacleMemory
{
 public:
    explicit ObstacleMemory(const GuardOptions& options);

    /// Keeps what a picture has hit, seen from where its vehicle was.
    void add(const ScanPicture& picture, const Pose2& pose_map_vehicle, double time_s);

    /// Forgets what the picture shows, as free or as occupied, what is too old and what is too far;
    /// then the oldest, until the rest fits.
    void update(const ScanPicture& picture, const Pose2& pose_map_vehicle, double time_s);
    void clear();

    [[nodiscard]] PointsView points_map() const { return points_map_.view(); }

 private:
    double memory_s_;
    float range_m_;
    std::size_t capacity_;
    Points points_map_;
    std::vector<double> seen_s_;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>
#include <rtob/io/map_server.h>

#include <cstdint>
#include <vector>

namespace rtob
{
/// Draws scans into an occupancy image: cells that rays pass become free, cells where they end
/// occupied. Works on points, not on MRPT scans: a stored map can be drawn as well, and a picture
/// shows exactly what the scan filter let through.
class OccupancyRaster
{
 public:
    explicit OccupancyRaster(double resolution_m);

    /// The rays start at the laser, `pose_vehicle_laser` seen from the vehicle. Beyond
    /// max_range_m from there a ray is cut and marks no end. Points that are not finite are passed
    /// over. Throws std::length_error, and adds nothing, when the picture would get too large.
    void add_scan(
        const Pose2& pose_map_vehicle, PointsView points_vehicle, double max_range_m,
        const Pose2& pose_vehicle_laser = {});

    /// The part of the plane where something is known; one unknown cell when nothing is.
    [[nodiscard]] OccupancyImage image() const;

 private:
    struct Cell
    {
        std::int64_t x = 0, y = 0;
    };
    struct Ray
    {
        Cell end;
        bool is_hit = false;
    };

    [[nodiscard]] Cell cell_at(double x_map, double y_map) const;
    void collect_rays(
        const Pose2& pose_map_vehicle, const Pose2& pose_map_laser, PointsView points_vehicle,
        double max_range_m);
    void make_room(Cell low, Cell high);
    void free_ray(Cell from, Cell to);
    [[nodiscard]] std::int8_t& at(Cell cell)
    {
        return evidence_[static_cast<std::size_t>((cell.y - low_.y) * width_ + (cell.x - low_.x))];
    }

    double resolution_m_;
    Cell low_;  ///< the stored rectangle's lower left cell; cell (0, 0) starts at 0, 0
    std::int64_t width_ = 0, height_ = 0;
    std::vector<std::int8_t> evidence_;  ///< above 0: occupied, below: free; bottom row first
    std::vector<Ray> rays_;              ///< of the scan at hand
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>

#include <cmath>
#include <limits>
#include <vector>

namespace rtob::test
{
struct Wall
{
    double x0, y0, x1, y1;  ///< m, in map
};

/// A laser that looks around the vehicle's origin: beam i at first_angle_rad + i * step_rad.
struct Laser
{
    std::size_t beams = 360;
    double first_angle_rad = 0;
    double step_rad = 2 * 3.14159265358979323846 / 360;
    double max_range_m = 6;

    [[nodiscard]] double angle(std::size_t beam) const
    {
        return first_angle_rad + static_cast<double>(beam) * step_rad;
    }
};

/// Straight walls, and exact ranges to them.
class Room
{
 public:
    explicit Room(std::vector<Wall> walls) : walls_(std::move(walls)) {}

    /// To the nearest wall from (x, y) in this direction; infinite where there is none.
    [[nodiscard]] double range(double x, double y, double direction_rad) const
    {
        const double dx = std::cos(direction_rad), dy = std::sin(direction_rad);
        double nearest = std::numeric_limits<double>::infinity();
        for (const Wall& wall : walls_)
        {
            const double wx = wall.x1 - wall.x0, wy = wall.y1 - wall.y0;
            const double cross = dx * wy - dy * wx;
            if (cross == 0) continue;  // parallel
            const double ax = wall.x0 - x, ay = wall.y0 - y;
            const double along_beam = (ax * wy - ay * wx) / cross;
            const double along_wall = (ax * dy - ay * dx) / cross;
            if (along_beam > 0 && along_wall >= 0 && along_wall <= 1)
                nearest = std::min(nearest, along_beam);
        }
        return nearest;
    }

    /// One range a beam; 0 where nothing is within the laser's reach, as cheap lasers report it.
    [[nodiscard]] std::vector<float> ranges(
        const Pose2& pose_map_vehicle, const Laser& laser = {}) const
    {
        std::vector<float> ranges(laser.beams, 0.0f);
        for (std::size_t i = 0; i < laser.beams; ++i)
        {
            const double r = range(
                pose_map_vehicle.x, pose_map_vehicle.y, pose_map_vehicle.yaw + laser.angle(i));
            if (r <= laser.max_range_m) ranges[i] = static_cast<float>(r);
        }
        return ranges;
    }

    /// The same as points; beams that see nothing give none.
    [[nodiscard]] Points scan_vehicle(const Pose2& pose_map_vehicle, const Laser& laser = {}) const
    {
        const auto seen = ranges(pose_map_vehicle, laser);
        Points points_vehicle;
        for (std::size_t i = 0; i < laser.beams; ++i)
            if (seen[i] > 0)
                points_vehicle.add(
                    static_cast<float>(seen[i] * std::cos(laser.angle(i))),
                    static_cast<float>(seen[i] * std::sin(laser.angle(i))));
        return points_vehicle;
    }

    [[nodiscard]] const std::vector<Wall>& walls() const { return walls_; }

 private:
    std::vector<Wall> walls_;
};

/// 4 m x 3 m with one corner at the origin, and a cupboard in another, so that no turn of the room
/// looks like the room.
[[nodiscard]] inline Room room_4x3()
{
    return Room(
        {{0, 0, 4, 0}, {4, 0, 4, 3}, {4, 3, 0, 3}, {0, 3, 0, 0}, {3, 3, 3, 2}, {3, 2, 4, 2}});
}

/// The points seen from a pose, in map.
[[nodiscard]] inline Points moved(const Points& points_vehicle, const Pose2& pose_map_vehicle)
{
    const double c = std::cos(pose_map_vehicle.yaw), s = std::sin(pose_map_vehicle.yaw);
    Points points_map;
    for (std::size_t i = 0; i < points_vehicle.size(); ++i)
    {
        const double x = points_vehicle.x[i], y = points_vehicle.y[i];
        points_map.add(
            static_cast<float>(pose_map_vehicle.x + c * x - s * y),
            static_cast<float>(pose_map_vehicle.y + s * x + c * y));
    }
    return points_map;
}
}  // namespace rtob::test

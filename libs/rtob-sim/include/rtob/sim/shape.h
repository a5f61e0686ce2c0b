// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <cmath>
#include <variant>

/// Exact plane geometry of walls. All in metres and radians, in one frame.
namespace rtob::sim
{
struct Point2
{
    double x = 0, y = 0;
};

[[nodiscard]] inline Point2 operator-(Point2 a, Point2 b)
{
    return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] inline Point2 operator+(Point2 a, Point2 b)
{
    return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] inline Point2 operator*(double s, Point2 a)
{
    return {s * a.x, s * a.y};
}
[[nodiscard]] inline double dot(Point2 a, Point2 b)
{
    return a.x * b.x + a.y * b.y;
}
[[nodiscard]] inline double cross(Point2 a, Point2 b)
{
    return a.x * b.y - a.y * b.x;
}
[[nodiscard]] inline double length(Point2 a)
{
    return std::sqrt(dot(a, a));
}

struct Segment
{
    Point2 from, to;
};

/// A circle, or the part of it that starts at from_rad and goes on for sweep_rad, to the left.
struct Arc
{
    Point2 centre;
    double radius_m = 1;
    double from_rad = 0;
    double sweep_rad = full_turn_rad;  ///< in (0, full_turn_rad]

    static constexpr double full_turn_rad = 2 * 3.14159265358979323846;

    [[nodiscard]] bool has(double angle_rad) const
    {
        if (sweep_rad >= full_turn_rad) return true;
        double turned_rad = std::fmod(angle_rad - from_rad, full_turn_rad);
        if (turned_rad < 0) turned_rad += full_turn_rad;
        return turned_rad <= sweep_rad;
    }
};

using Shape = std::variant<Segment, Arc>;

[[nodiscard]] Shape moved(const Shape& shape, const Pose2& motion);

/// From a point to the nearest point of the shape.
[[nodiscard]] double distance(Point2 point, const Segment& segment);
[[nodiscard]] double distance(Point2 point, const Arc& arc);

/// How often the outline crosses a ray from the point to far away.
[[nodiscard]] int crossings(Point2 point, const Segment& segment);
[[nodiscard]] int crossings(Point2 point, const Arc& arc);
}  // namespace rtob::sim

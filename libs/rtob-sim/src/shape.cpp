// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/sim/shape.h>

#include <algorithm>

namespace rtob::sim
{
namespace
{
Point2 moved_point(Point2 p, const Pose2& motion)
{
    const double c = std::cos(motion.yaw), s = std::sin(motion.yaw);
    return {motion.x + c * p.x - s * p.y, motion.y + s * p.x + c * p.y};
}

Point2 on_circle(const Arc& arc, double angle_rad)
{
    return arc.centre + arc.radius_m * Point2{std::cos(angle_rad), std::sin(angle_rad)};
}
/// Of the ray that crossings are counted on: no wall is likely to be parallel to it.
const Point2 outward{std::cos(0.7391), std::sin(0.7391)};
}  // namespace

Shape moved(const Shape& shape, const Pose2& motion)
{
    if (const auto* segment = std::get_if<Segment>(&shape))
        return Segment{moved_point(segment->from, motion), moved_point(segment->to, motion)};
    Arc arc = std::get<Arc>(shape);
    arc.centre = moved_point(arc.centre, motion);
    arc.from_rad += motion.yaw;
    return arc;
}

double distance(Point2 point, const Segment& segment)
{
    const Point2 along = segment.to - segment.from, to_point = point - segment.from;
    const double length2 = dot(along, along);
    const double share = length2 > 0 ? std::clamp(dot(to_point, along) / length2, 0.0, 1.0) : 0.0;
    return length(to_point - share * along);
}

double distance(Point2 point, const Arc& arc)
{
    const Point2 out = point - arc.centre;
    if (arc.has(std::atan2(out.y, out.x))) return std::abs(length(out) - arc.radius_m);
    return std::min(
        length(point - on_circle(arc, arc.from_rad)),
        length(point - on_circle(arc, arc.from_rad + arc.sweep_rad)));
}

int crossings(Point2 point, const Segment& segment)
{
    // One end of the segment is counted, the other is not: outlines meet there.
    const double a = cross(outward, segment.from - point), b = cross(outward, segment.to - point);
    if ((a < 0) == (b < 0)) return 0;
    const double share = a / (a - b);
    const Point2 met = segment.from + share * (segment.to - segment.from) - point;
    return dot(met, outward) > 0 ? 1 : 0;
}

int crossings(Point2 point, const Arc& arc)
{
    const Point2 from_centre = point - arc.centre;
    const double half = dot(from_centre, outward), offset = cross(from_centre, outward);
    const double chord2 = arc.radius_m * arc.radius_m - offset * offset;
    if (chord2 < 0) return 0;
    int count = 0;
    for (const double distance_m : {-half - std::sqrt(chord2), -half + std::sqrt(chord2)})
    {
        const Point2 out = from_centre + distance_m * outward;
        if (distance_m > 0 && arc.has(std::atan2(out.y, out.x))) ++count;
    }
    return count;
}
}  // namespace rtob::sim

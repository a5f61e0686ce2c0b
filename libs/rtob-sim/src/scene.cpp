// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/sim/scene.h>

#include <algorithm>

namespace rtob::sim
{
namespace
{
constexpr double hidden = -1;

/// The part of the plane that a bundle can reach, as two half-planes and a disc: what lies wholly
/// outside one of them cannot be met.
class Cone
{
 public:
    explicit Cone(const Bundle& bundle)
        : origin_(bundle.origin_map),
          right_normal_(normal(bundle.from_rad)),
          left_normal_(-1.0 * normal(bundle.from_rad + bundle.sweep_rad)),
          spread_m_(bundle.spread_m + rounding_m),
          reach_m_(bundle.reach_m + spread_m_)
    {
    }

    [[nodiscard]] bool mayMeet(Point2 middle, double radius_m) const
    {
        const Point2 p = middle - origin_;
        const double near_m = reach_m_ + radius_m;
        return dot(p, p) <= near_m * near_m && isInside(p, radius_m);
    }
    [[nodiscard]] bool mayMeet(const Segment& segment) const
    {
        const Point2 a = segment.from - origin_, b = segment.to - origin_;
        return !(outside(right_normal_, a, 0) && outside(right_normal_, b, 0)) &&
               !(outside(left_normal_, a, 0) && outside(left_normal_, b, 0));
    }

 private:
    static constexpr double rounding_m = 1e-6;

    /// Of the line in this direction, to its left.
    static Point2 normal(double angle_rad) { return {-std::sin(angle_rad), std::cos(angle_rad)}; }
    [[nodiscard]] bool outside(Point2 inward, Point2 p, double radius_m) const
    {
        return dot(inward, p) < -(radius_m + spread_m_);
    }
    [[nodiscard]] bool isInside(Point2 p, double radius_m) const
    {
        return !outside(right_normal_, p, radius_m) && !outside(left_normal_, p, radius_m);
    }

    Point2 origin_, right_normal_, left_normal_;
    double spread_m_, reach_m_;
};

bool isAtHeight(double z_m, double z_min_m, double z_max_m)
{
    return z_min_m <= z_m && z_m <= z_max_m;
}
}  // namespace

Scene::Scene(World world) : world_(std::move(world))
{
    const auto next_place = [this]
    {
        return Place{
            static_cast<std::uint32_t>(places_.size()),
            static_cast<std::uint32_t>(segments_.size()), static_cast<std::uint32_t>(arcs_.size())};
    };
    for (std::uint32_t i = 0; i < world_.objects.size(); ++i)
    {
        const auto& object = world_.objects[i];
        places_.push_back(next_place());
        for (const auto& shape : object.shapes_object)
            if (std::holds_alternative<Segment>(shape))
                segments_.emplace_back();
            else
                arcs_.emplace_back();
        place(places_.back(), 0);
        if (!object.isStatic()) timetabled_.push_back(i);
    }
    places_.push_back(next_place());
}

void Scene::place(const Place& here, double time_s)
{
    const Object& object = world_.objects[here.object];
    const Pose2 pose_map_object = object.pose_map_object(time_s);
    const bool is_present = object.isPresent(time_s);
    auto next_segment = here.first_segment, next_arc = here.first_arc;
    const auto fill = [&](Solid& solid, Point2 middle, double reach_m)
    {
        solid.z_min_m = object.z_min_m;
        solid.z_max_m = object.z_max_m;
        solid.object = here.object;
        solid.middle_map = middle;
        solid.reach_m = is_present ? reach_m : hidden;
    };
    for (const auto& shape : object.shapes_object)
    {
        const Shape shape_map = moved(shape, pose_map_object);
        if (const auto* segment = std::get_if<Segment>(&shape_map))
        {
            auto& solid = segments_[next_segment++];
            solid.shape = *segment;
            fill(
                solid, 0.5 * (segment->from + segment->to),
                0.5 * length(segment->to - segment->from));
        }
        else
        {
            auto& solid = arcs_[next_arc++];
            solid.shape = std::get<Arc>(shape_map);
            fill(solid, solid.shape.centre, solid.shape.radius_m);
        }
    }
}

void Scene::moveTo(double time_s)
{
    for (const auto object : timetabled_) place(places_[object], time_s);
}

void Scene::meet(const Beam& beam, const SolidSegment& segment, double min_distance_m, Hit& nearest)
{
    constexpr double corner = 1e-9;  // of its length: no beam slips through where two walls meet
    const Point2 along = segment.shape.to - segment.shape.from;
    const double turn = cross(along, beam.direction_map);
    if (turn == 0 || segment.reach_m < 0) return;
    const Point2 to_start = segment.shape.from - beam.origin_map;
    const double distance_m = cross(along, to_start) / turn;
    if (!(distance_m > min_distance_m) || distance_m >= nearest.distance_m) return;
    const double share = cross(beam.direction_map, to_start) / turn;
    if (share < -corner || share > 1 + corner) return;
    if (!isAtHeight(beam.height_at(distance_m), segment.z_min_m, segment.z_max_m)) return;
    nearest = {distance_m, segment.object, (1 / length(along)) * Point2{-along.y, along.x}};
}

void Scene::meet(const Beam& beam, const SolidArc& arc, double min_distance_m, Hit& nearest)
{
    if (arc.reach_m < 0) return;
    const Point2 from_centre = beam.origin_map - arc.shape.centre;
    const double half = dot(from_centre, beam.direction_map);
    const double offset = cross(from_centre, beam.direction_map);
    const double chord2 = arc.shape.radius_m * arc.shape.radius_m - offset * offset;
    if (chord2 < 0) return;
    for (const double sign : {-1.0, 1.0})
    {
        const double distance_m = -half + sign * std::sqrt(chord2);
        if (!(distance_m > min_distance_m)) continue;
        if (distance_m >= nearest.distance_m) return;
        const Point2 out = from_centre + distance_m * beam.direction_map;
        if (!arc.shape.has(std::atan2(out.y, out.x))) continue;
        if (!isAtHeight(beam.height_at(distance_m), arc.z_min_m, arc.z_max_m)) continue;
        nearest = {distance_m, arc.object, (1 / arc.shape.radius_m) * out};
        return;
    }
}

void Scene::meetFloorAndCeiling(const Beam& beam, double min_distance_m, Hit& nearest) const
{
    if (beam.slope == 0) return;
    const double height_m = beam.slope < 0 ? world_.floor_m : world_.ceiling_m;
    const double distance_m = (height_m - beam.z_m) / beam.slope;
    if (distance_m > min_distance_m && distance_m < nearest.distance_m)
        nearest = {distance_m, 0, {}};
}

Hit Scene::cast(const Beam& beam, double min_distance_m) const
{
    Hit nearest;
    for (const auto& segment : segments_) meet(beam, segment, min_distance_m, nearest);
    for (const auto& arc : arcs_) meet(beam, arc, min_distance_m, nearest);
    meetFloorAndCeiling(beam, min_distance_m, nearest);
    return nearest;
}

Hit Scene::cast(const Beam& beam, const Selection& selection, double min_distance_m) const
{
    Hit nearest;
    for (const auto i : selection.segments) meet(beam, segments_[i], min_distance_m, nearest);
    for (const auto i : selection.arcs) meet(beam, arcs_[i], min_distance_m, nearest);
    meetFloorAndCeiling(beam, min_distance_m, nearest);
    return nearest;
}

void Scene::select(const Bundle& bundle, Selection& selection) const
{
    selection.segments.clear();
    selection.arcs.clear();
    const Cone cone(bundle);
    for (std::uint32_t i = 0; i < segments_.size(); ++i)
    {
        const auto& segment = segments_[i];
        if (segment.reach_m >= 0 && cone.mayMeet(segment.middle_map, segment.reach_m) &&
            cone.mayMeet(segment.shape))
            selection.segments.push_back(i);
    }
    for (std::uint32_t i = 0; i < arcs_.size(); ++i)
        if (arcs_[i].reach_m >= 0 && cone.mayMeet(arcs_[i].middle_map, arcs_[i].reach_m))
            selection.arcs.push_back(i);
}

bool Scene::isInside(Point2 point_map, double z_m, const Place& here) const
{
    const Object& object = world_.objects[here.object];
    if (!object.is_solid || !isAtHeight(z_m, object.z_min_m, object.z_max_m)) return false;
    const Place& behind = places_[here.object + 1];
    int count = 0;
    for (auto i = here.first_segment; i < behind.first_segment; ++i)
        if (segments_[i].reach_m >= 0) count += crossings(point_map, segments_[i].shape);
    for (auto i = here.first_arc; i < behind.first_arc; ++i)
        if (arcs_[i].reach_m >= 0) count += crossings(point_map, arcs_[i].shape);
    return count % 2 == 1;
}

double Scene::clearance_m(Point2 point_map, double z_m) const
{
    double nearest_m = std::numeric_limits<double>::infinity();
    const auto look = [&](const auto& solid)
    {
        if (solid.reach_m >= 0 && isAtHeight(z_m, solid.z_min_m, solid.z_max_m))
            nearest_m = std::min(nearest_m, distance(point_map, solid.shape));
    };
    for (const auto& segment : segments_) look(segment);
    for (const auto& arc : arcs_) look(arc);
    const bool is_inside = std::any_of(
        places_.begin(), std::prev(places_.end()),
        [&](const Place& here) { return isInside(point_map, z_m, here); });
    return is_inside ? 0 : nearest_m;
}
}  // namespace rtob::sim

// SPDX-License-Identifier: BSD-3-Clause
#include "world_objects.h"

#include <array>
#include <filesystem>

#include "plan_outline.h"

namespace rtob::sim
{
namespace
{
constexpr double rad_per_deg = 3.14159265358979323846 / 180;

/// What an entry of `objects:` is before its timetable: shapes about the origin, and where they
/// stand.
struct Placed
{
    std::vector<Shape> shapes_object;
    Pose2 pose_map_object;
    bool is_solid = false;
};

void add_line(std::vector<Shape>& shapes, const std::vector<Point2>& points, bool closed)
{
    for (std::size_t i = 1; i < points.size(); ++i)
        shapes.emplace_back(Segment{points[i - 1], points[i]});
    if (closed) shapes.emplace_back(Segment{points.back(), points.front()});
}

Pose2 read_place(YamlFields& fields)
{
    Point2 at;
    double yaw_deg = 0;
    fields.read("at", at);
    fields.read("yaw_deg", yaw_deg);
    return {at.x, at.y, wrap_angle(yaw_deg * rad_per_deg)};
}

/// Its first point is the object's origin: a door turns about its hinge.
Placed read_wall(YamlFields& fields)
{
    std::vector<Point2> points;
    bool closed = false;
    fields.read("points", points);
    fields.read("closed", closed);
    if (points.size() < 2) fields.fail("points: a wall needs at least two");
    const Point2 origin = points.front();
    for (auto& point : points) point = point - origin;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (length(points[i] - points[i - 1]) == 0)
            fields.fail("points", "point " + std::to_string(i + 1) + " repeats the one before");
    Placed placed{{}, {origin.x, origin.y, 0}, false};
    add_line(placed.shapes_object, points, closed);
    return placed;
}

Placed read_circle(YamlFields& fields)
{
    Arc circle;
    fields.read("radius_m", circle.radius_m, Range::positive());
    return {{circle}, read_place(fields), true};
}

Placed read_arc(YamlFields& fields)
{
    Arc arc;
    double from_deg = 0, to_deg = 180;
    fields.read("radius_m", arc.radius_m, Range::positive());
    fields.read("from_deg", from_deg);
    fields.read("to_deg", to_deg);
    if (to_deg <= from_deg || to_deg - from_deg > 360)
        fields.fail("to_deg", "must be more than from_deg, by 360 at most: arcs run to the left");
    arc.from_rad = from_deg * rad_per_deg;
    arc.sweep_rad = (to_deg - from_deg) * rad_per_deg;
    return {{arc}, read_place(fields), false};
}

Placed read_box(YamlFields& fields)
{
    std::vector<double> size_m{1, 1};
    fields.read("size_m", size_m, 2);
    if (size_m[0] <= 0 || size_m[1] <= 0)
        fields.fail("size_m", "both numbers must be above 0: along x and along y");
    const double x = size_m[0] / 2, y = size_m[1] / 2;
    Placed placed{{}, read_place(fields), true};
    add_line(placed.shapes_object, {{-x, -y}, {x, -y}, {x, y}, {-x, y}}, true);
    return placed;
}

/// A picture or an MRPT grid map; `at` is its lower left corner.
Placed read_plan(YamlFields& fields)
{
    std::string file;
    double resolution_m = 0.05;
    fields.read("file", file);
    const bool has_resolution = fields.has("resolution_m");
    fields.read("resolution_m", resolution_m, Range::positive());
    const auto path = std::filesystem::path(fields.file()).parent_path() / file;
    Plan plan;
    try
    {
        plan = read_plan_file(path.string(), has_resolution ? resolution_m : 0.0);
    }
    catch (const std::runtime_error& error)
    {
        fields.fail("file", error.what());
    }
    Placed placed{std::move(plan.outline), {plan.corner_map.x, plan.corner_map.y, 0}, true};
    if (fields.has("at")) placed.pose_map_object = read_place(fields);
    return placed;
}

struct Kind
{
    const char* name;
    Placed (*read)(YamlFields&);
};
constexpr std::array<Kind, 5> kinds{
    {{"wall", read_wall},
     {"circle", read_circle},
     {"arc", read_arc},
     {"box", read_box},
     {"plan", read_plan}}};

Placed read_shape(YamlFields& fields)
{
    const Kind* found = nullptr;
    for (const auto& kind : kinds)
    {
        if (!fields.has(kind.name)) continue;
        if (found != nullptr)
            fields.fail(std::string("has both a ") + found->name + " and a " + kind.name);
        found = &kind;
    }
    if (found == nullptr)
    {
        fields.allow({"name", "height_m", "surface", "present_s", "moves"});
        fields.finish();
        fields.fail("has no shape; known: wall, circle, arc, box, plan");
    }
    auto shape = *fields.fields(found->name);
    Placed placed = found->read(shape);
    shape.finish();
    return placed;
}

Surface read_surface(YamlFields fields)
{
    Surface surface;
    fields.read("transparency", surface.transparency, Range::share());
    fields.read("mirror", surface.mirror, Range::share());
    fields.read("dropout", surface.dropout, Range::share());
    fields.finish();
    return surface;
}

void read_height(YamlFields& fields, Object& object)
{
    std::vector<double> height_m{object.z_min_m, object.z_max_m};
    fields.read("height_m", height_m, 2);
    if (height_m[0] >= height_m[1])
        fields.fail("height_m", "[from, to] in metres: the second must be above the first");
    object.z_min_m = height_m[0];
    object.z_max_m = height_m[1];
}

void read_moves(YamlFields& fields, Object& object)
{
    for (auto& move : fields.list("moves"))
    {
        double at_s = 0, over_s = 0, turn_deg = 0;
        Point2 shift;
        move.read("at_s", at_s, Range::notNegative());
        move.read("over_s", over_s, Range::notNegative());
        move.read("shift_m", shift);
        move.read("turn_deg", turn_deg);
        move.finish();
        Pose2 pose = object.placements.back().pose_map_object;
        if (at_s < object.placements.back().time_s)
            move.fail("at_s", "starts before the move above it has ended");
        object.placements.push_back({at_s, pose});
        pose.x += shift.x;
        pose.y += shift.y;
        pose.yaw = wrap_angle(pose.yaw + turn_deg * rad_per_deg);
        object.placements.push_back({at_s + over_s, pose});
    }
}
}  // namespace

Object read_object(YamlFields fields)
{
    Object object;
    const Placed placed = read_shape(fields);
    object.shapes_object = placed.shapes_object;
    object.is_solid = placed.is_solid;
    object.placements = {{0, placed.pose_map_object}};
    fields.read("name", object.name);
    read_height(fields, object);
    if (const auto surface = fields.fields("surface")) object.surface = read_surface(*surface);
    std::vector<Point2> present_s;  // pairs of times
    fields.read("present_s", present_s);
    for (const auto& [from_s, to_s] : present_s)
    {
        if (to_s <= from_s) fields.fail("present_s", "[from, to]: must end after it began");
        object.present.push_back({from_s, to_s});
    }
    read_moves(fields, object);
    fields.finish();
    return object;
}

Object read_person(YamlFields fields)
{
    Walk walk;
    fields.read("path", walk.path_map);
    fields.read("speed_mps", walk.speed_mps, Range::positive());
    fields.read("start_s", walk.start_s, Range::notNegative());
    fields.read("end_s", walk.end_s, Range::notNegative());
    fields.read("radius_m", walk.body_radius_m, Range::positive());
    fields.read("height_m", walk.height_m, Range::positive());
    fields.read("there_and_back", walk.there_and_back);
    fields.finish();
    if (walk.path_map.size() < 2) fields.fail("path: needs at least two points");
    for (std::size_t i = 1; i < walk.path_map.size(); ++i)
        if (length(walk.path_map[i] - walk.path_map[i - 1]) == 0)
            fields.fail("path", "point " + std::to_string(i + 1) + " repeats the one before");
    if (walk.end_s <= walk.start_s) fields.fail("end_s", "must be after start_s");
    return walking_person(walk);
}
}  // namespace rtob::sim

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/enum_names.h>
#include <rtob/sim/world_file.h>

#include <algorithm>
#include <filesystem>

#include "world_objects.h"
#include "yaml_fields.h"

namespace rtob::sim
{
namespace
{
constexpr double rad_per_deg = 3.14159265358979323846 / 180;

/// All keys of an options struct, and what its validate() says of them together.
template <class Options>
void read_options(YamlFields& fields, Options& options)
{
    Options::fields(
        options, [&](const char* key, auto& value, const char*) { fields.read(key, value); });
    fields.finish();
    try
    {
        options.validate();
    }
    catch (const std::invalid_argument& error)
    {
        const std::string message = error.what();
        const auto key = message.substr(0, message.find(' '));
        fields.fail(key, message);
    }
}

template <class Enum>
void read_enum(YamlFields& fields, const std::string& key, Enum& value)
{
    std::string name;
    fields.read(key, name);
    if (name.empty()) return;
    try
    {
        value = parse_enum<Enum>(name);
    }
    catch (const std::invalid_argument& error)
    {
        fields.fail(key, error.what());
    }
}

void read_start(YamlFields fields, Pose3& start_map)
{
    Point2 at;
    double yaw_deg = 0;
    fields.read("at", at);
    fields.read("yaw_deg", yaw_deg);
    fields.read("altitude_m", start_map.z, Range::notNegative());
    fields.finish();
    start_map.x = at.x;
    start_map.y = at.y;
    start_map.yaw = wrap_angle(yaw_deg * rad_per_deg);
}

/// A waypoint without an altitude keeps that of the one before.
void read_route(YamlFields& fields, double altitude_m, std::vector<Waypoint>& route)
{
    for (auto& entry : fields.list("route"))
    {
        Waypoint waypoint;
        if (!entry.has("to")) entry.fail("needs `to: [x, y]`");
        entry.read("to", waypoint.at_map);
        entry.read("altitude_m", altitude_m, Range::notNegative());
        entry.read("hold_s", waypoint.hold_s, Range::notNegative());
        entry.finish();
        waypoint.altitude_m = altitude_m;
        route.push_back(waypoint);
    }
}

void read_flight(YamlFields fields, double start_altitude_m, FlightPlan& flight)
{
    fields.read("duration_s", flight.duration_s, Range::positive());
    fields.read("speed_mps", flight.speed_mps, Range::positive());
    fields.read("climb_mps", flight.climb_mps, Range::positive());
    fields.read("yaw_rate_dps", flight.yaw_rate_dps);
    fields.read("repeat", flight.repeat);
    read_enum(fields, "heading", flight.heading);
    read_route(fields, start_altitude_m, flight.route);
    fields.finish();
}

/// Without what may be elsewhere by then.
World static_part(World world)
{
    const auto moves = [](const Object& object) { return !object.isStatic(); };
    auto& objects = world.objects;
    objects.erase(std::remove_if(objects.begin(), objects.end(), moves), objects.end());
    return world;
}

/// Nobody notices a route through a wall in a log, where it looks like bad matching.
void check_route(const WorldFile& world)
{
    const Scene scene(static_part(world.world));
    const auto& start = world.simulation.start_map;
    Waypoint from{{start.x, start.y}, start.z, 0};
    const auto at_line = [](const WorldFile& w, const std::string& what)
    { return std::to_string(w.flight_line) + ": flight.route: " + what; };
    for (std::size_t i = 0; i < world.flight.route.size(); ++i)
    {
        const Waypoint& to = world.flight.route[i];
        const Point2 way = to.at_map - from.at_map;
        const double way_m = length(way);
        if (way_m > 0)
        {
            const double slope = (to.altitude_m - from.altitude_m) / way_m;
            const Hit hit = scene.cast({from.at_map, from.altitude_m, (1 / way_m) * way, slope});
            if (hit.distance_m < way_m)
                throw WorldError(at_line(
                    world, "the way to waypoint " + std::to_string(i + 1) +
                               " goes through a wall, " + std::to_string(hit.distance_m) +
                               " m after the one before"));
        }
        from = to;
    }
}

void check_start(const WorldFile& world)
{
    try
    {
        (void)Simulation(world.world, world.simulation);
    }
    catch (const std::invalid_argument& error)
    {
        throw WorldError(std::to_string(world.start_line) + ": start: " + error.what());
    }
}

WorldFile read_fields(YamlFields fields)
{
    WorldFile result;
    auto& [laser, vehicle, sensors, start_map, seed] = result.simulation;
    fields.read("name", result.world.name);
    fields.read("floor_m", result.world.floor_m);
    fields.read("ceiling_m", result.world.ceiling_m);
    if (auto section = fields.fields("laser")) read_options(*section, laser);
    if (auto section = fields.fields("vehicle"))
    {
        read_enum(*section, "kind", vehicle.kind);
        read_options(*section, vehicle);
    }
    if (auto section = fields.fields("sensors")) read_options(*section, sensors);
    result.start_line = fields.line();
    if (auto section = fields.fields("start"))
    {
        result.start_line = section->line();
        read_start(*section, start_map);
    }
    if (auto section = fields.fields("flight"))
    {
        result.flight_line = section->line();
        read_flight(*section, start_map.z, result.flight);
    }
    for (const auto& entry : fields.list("objects"))
        result.world.objects.push_back(read_object(entry));
    for (const auto& entry : fields.list("people"))
        result.world.objects.push_back(read_person(entry));
    fields.finish();
    if (result.world.objects.empty()) fields.fail("holds no objects: a laser would see nothing");
    return result;
}

YAML::Node load(const std::string& file)
{
    if (!std::filesystem::is_regular_file(file)) throw WorldError(file + ": no such file");
    try
    {
        return YAML::LoadFile(file);
    }
    catch (const YAML::Exception& error)
    {
        throw WorldError(
            file + ":" + std::to_string(error.mark.line + 1) + ": not YAML: " + error.msg);
    }
}
}  // namespace

WorldFile read_world(const std::string& file)
{
    WorldFile world = read_fields(YamlFields(file, load(file), ""));
    if (world.world.name.empty()) world.world.name = std::filesystem::path(file).stem().string();
    try
    {
        check_start(world);
        check_route(world);
    }
    catch (const WorldError& error)
    {
        throw WorldError(file + ":" + error.what());
    }
    return world;
}
}  // namespace rtob::sim

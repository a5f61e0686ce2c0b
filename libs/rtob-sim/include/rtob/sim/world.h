// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <rtob/sim/shape.h>

#include <limits>
#include <string>
#include <vector>

/// What stands around the vehicle. The world's frame is called map here: x, y in the plane, z up.
namespace rtob::sim
{
/// How a thing looks to a laser; chances in [0, 1], drawn for each beam that meets it.
struct Surface
{
    double transparency = 0;  ///< the beam goes on behind it, as through glass
    double mirror = 0;        ///< else: the beam is thrown back at the angle at which it came
    double dropout = 0;       ///< else: nothing comes back, as from black or shiny things

    [[nodiscard]] bool isPlain() const { return transparency == 0 && mirror == 0 && dropout == 0; }
};

struct Interval
{
    double from_s = -std::numeric_limits<double>::infinity();
    double to_s = std::numeric_limits<double>::infinity();
};

/// The thing is at this pose at this time; in between it moves at a constant rate.
struct Placement
{
    double time_s = 0;
    Pose2 pose_map_object;
};

struct Object
{
    std::string name;
    std::vector<Shape> shapes_object;  ///< in the object's own frame
    double z_min_m = 0, z_max_m = 3;
    bool is_solid = false;  ///< its shapes are the outline of something one can be inside of
    Surface surface;
    std::vector<Placement> placements;  ///< by time; none: at the origin of map
    std::vector<Interval> present;      ///< none: always

    [[nodiscard]] bool isStatic() const { return placements.size() < 2 && present.empty(); }
    [[nodiscard]] bool isPresent(double time_s) const;
    /// Before the first placement it stands there, and after the last too.
    [[nodiscard]] Pose2 pose_map_object(double time_s) const;
};

/// Someone who walks along a path, to its end and back, as long as the world lasts.
struct Walk
{
    std::vector<Point2> path_map;
    double speed_mps = 1.2;
    double start_s = 0;
    double end_s = 3600;
    double body_radius_m = 0.2;
    double height_m = 1.8;
    bool there_and_back = true;  ///< else it leaves at the path's end
};

/// A person as an object with a timetable.
[[nodiscard]] Object walking_person(const Walk& walk);

struct World
{
    std::string name;
    std::vector<Object> objects;
    double floor_m = 0;
    double ceiling_m = std::numeric_limits<double>::infinity();
};
}  // namespace rtob::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/sim/world.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace rtob::sim
{
/// A straight beam. Its length is measured in the plane: at distance d it is slope * d higher.
struct Beam
{
    Point2 origin_map;
    double z_m = 0;
    Point2 direction_map{1, 0};  ///< unit vector in the plane
    double slope = 0;            ///< rise per metre in the plane

    [[nodiscard]] double height_at(double distance_m) const { return z_m + slope * distance_m; }
};

struct Hit
{
    double distance_m = std::numeric_limits<double>::infinity();  ///< in the plane
    std::uint32_t object = 0;                                     ///< its place in the world
    Point2 normal_map;  ///< of the surface; either side. (0, 0): floor or ceiling

    [[nodiscard]] bool met() const { return distance_m < std::numeric_limits<double>::infinity(); }
};

/// Beams from about one place into about one direction.
struct Bundle
{
    Point2 origin_map;
    double spread_m = 0;   ///< no beam starts farther than this from the origin
    double from_rad = 0;   ///< the rightmost direction of its beams, in map
    double sweep_rad = 0;  ///< and how far they reach to the left; below half a turn
    double reach_m = 0;    ///< no beam is followed farther than this
};

/// The shapes that the beams of a bundle can meet.
struct Selection
{
    std::vector<std::uint32_t> segments, arcs;
};

/// The world at one instant, ready for casting beams. Exact: no raster, no approximation.
class Scene
{
 public:
    explicit Scene(World world);

    /// Moves, shows and hides what has a timetable. Cheap when little has.
    void moveTo(double time_s);
    [[nodiscard]] const World& world() const { return world_; }

    /// The nearest thing that the beam meets farther than min_distance_m; floor and ceiling too.
    [[nodiscard]] Hit cast(const Beam& beam, double min_distance_m = 0) const;
    /// The same, looking only at selected shapes.
    [[nodiscard]] Hit cast(
        const Beam& beam, const Selection& selection, double min_distance_m = 0) const;
    void select(const Bundle& bundle, Selection& selection) const;

    /// From a point at this height to the nearest thing there; 0 inside a solid object.
    [[nodiscard]] double clearance_m(Point2 point_map, double z_m) const;

 private:
    struct Solid
    {
        double z_min_m = 0, z_max_m = 0;
        std::uint32_t object = 0;
        Point2 middle_map;   ///< of a circle around the shape
        double reach_m = 0;  ///< the radius of that circle; negative: hidden
    };
    struct SolidSegment : Solid
    {
        Segment shape;
    };
    struct SolidArc : Solid
    {
        Arc shape;
    };
    /// Where the shapes of an object are: it follows the one before.
    struct Place
    {
        std::uint32_t object, first_segment, first_arc;
    };

    void place(const Place& place, double time_s);
    [[nodiscard]] bool isInside(Point2 point_map, double z_m, const Place& place) const;
    static void meet(
        const Beam& beam, const SolidSegment& segment, double min_distance_m, Hit& nearest);
    static void meet(const Beam& beam, const SolidArc& arc, double min_distance_m, Hit& nearest);
    void meetFloorAndCeiling(const Beam& beam, double min_distance_m, Hit& nearest) const;

    World world_;
    std::vector<SolidSegment> segments_;
    std::vector<SolidArc> arcs_;
    std::vector<Place> places_;              ///< of all objects, and one behind the last
    std::vector<std::uint32_t> timetabled_;  ///< objects
};
}  // namespace rtob::sim

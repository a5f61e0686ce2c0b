// SPDX-License-Identifier: BSD-3-Clause
#include "fly_world.h"

#include <rtob/core/nearest_name.h>

#include <functional>
#include <map>
#include <stdexcept>

namespace rtob::fly
{
namespace
{
class Builder
{
 public:
    explicit Builder(const char* name) { built_.name = built_.world.name = name; }

    Builder& line(const std::vector<sim::Point2>& corners)
    {
        sim::Object wall;
        wall.name = "wall";
        for (std::size_t i = 1; i < corners.size(); ++i)
            wall.shapes_object.push_back(sim::Segment{corners[i - 1], corners[i]});
        built_.world.objects.push_back(wall);
        return *this;
    }
    /// 10 cm thick, along x or y: a wall without thickness could not be seen end on.
    Builder& wall(double x0, double y0, double x1, double y1)
    {
        return box(x0 - 0.05, y0 - 0.05, x1 + 0.05, y1 + 0.05);
    }
    Builder& box(double x0, double y0, double x1, double y1)
    {
        return line({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}});
    }
    Builder& post(double x, double y, double radius_m)
    {
        sim::Object post;
        post.name = "post";
        post.shapes_object.push_back(sim::Arc{{x, y}, radius_m});
        built_.world.objects.push_back(post);
        return *this;
    }
    [[nodiscard]] FlyWorld inside(const Box& area, std::vector<Eigen::Vector2d> route)
    {
        built_.area = area;
        built_.route_map = std::move(route);
        return built_;
    }

 private:
    FlyWorld built_;
};

/// The paper's room: 4.8 m x 3.7 m, with a heater and the board that the pilot stands behind.
FlyWorld room()
{
    return Builder("room")
        .box(0, 0, 4.8, 3.7)
        .box(0.5, 3.55, 1.7, 3.7)
        .wall(4.1, 1.2, 4.75, 1.2)
        .wall(4.1, 0.4, 4.1, 1.2)
        .inside({0, 0, 4.8, 3.7}, {{1, 1}, {3.4, 2.8}, {1, 2.8}, {3.2, 0.8}});
}

/// Out of a garage into a yard with a side wall and a bin, and back.
FlyWorld garage()
{
    return Builder("garage")
        .line({{6, 0}, {0, 0}, {0, 3.2}, {6, 3.2}})
        .line({{6, 0}, {6, -4}, {13, -4}, {13, 7}, {6, 7}, {6, 3.2}})
        .wall(5.95, 0.05, 5.95, 0.35)
        .wall(5.95, 2.85, 5.95, 3.15)
        .box(6, 2.8, 6.3, 5)
        .box(9, 3, 9.6, 3.7)
        .post(10.5, -1.5, 0.15)
        .box(0.2, 2.6, 2.4, 3.0)
        .inside({0, -4, 13, 7}, {{1.5, 1.3}, {7.5, 1.6}, {11.5, 5}, {11.5, -3}, {7.5, -2.5}});
}

/// Four rooms and a hall; doors of 1.0 m and more, tables on thin legs, chairs, a bed, a sofa.
FlyWorld flat()
{
    return Builder("flat")
        .box(0, 0, 10, 8)
        .wall(0, 3.4, 1.8, 3.4)
        .wall(2.9, 3.4, 6.6, 3.4)
        .wall(7.8, 3.4, 10, 3.4)
        .wall(0, 5.0, 2.2, 5.0)
        .wall(3.4, 5.0, 7.0, 5.0)
        .wall(8.1, 5.0, 10, 5.0)
        .wall(4.6, 0, 4.6, 3.4)
        .wall(5.2, 5.0, 5.2, 8)
        .post(1.4, 1.2, 0.03)
        .post(2.8, 1.2, 0.03)
        .post(1.4, 2.0, 0.03)
        .post(2.8, 2.0, 0.03)
        .box(5.2, 0.1, 7.2, 0.9)
        .post(8.8, 1.6, 0.25)
        .box(9.5, 2.2, 9.95, 3.2)
        .box(0.1, 6.2, 2.1, 7.8)
        .box(3.9, 7.4, 5.1, 7.9)
        .post(7.2, 6.8, 0.4)
        .post(6.2, 6.5, 0.03)
        .post(9.3, 7.2, 0.2)
        .inside(
            {0, 0, 10, 8}, {{3.6, 2.6},
                            {2.35, 2.8},
                            {2.35, 4.2},
                            {2.8, 6},
                            {2.8, 4.2},
                            {7.55, 4.2},
                            {7.55, 6},
                            {7.2, 4.2},
                            {7.2, 2.2},
                            {7.2, 4.2},
                            {9, 4.2}});
}

/// Passages of 1.5 m; the walls are 0.1 m thick.
FlyWorld maze()
{
    constexpr double kCell_m = 1.6;
    Builder builder("maze");
    const auto wall = [&](double column0, double row0, double column1, double row1)
    {
        builder.box(
            column0 * kCell_m - 0.05, row0 * kCell_m - 0.05, column1 * kCell_m + 0.05,
            row1 * kCell_m + 0.05);
    };
    builder.box(0, 0, 7 * kCell_m, 6 * kCell_m);
    wall(1, 0, 1, 2), wall(1, 3, 1, 5), wall(2, 1, 2, 3), wall(2, 3, 4, 3), wall(3, 0, 3, 2);
    wall(2, 4, 2, 6), wall(3, 4, 3, 5), wall(4, 1, 4, 3), wall(4, 4, 6, 4), wall(5, 0, 5, 2);
    wall(5, 2, 6, 2), wall(4, 5, 4, 6), wall(5, 5, 7, 5), wall(6, 3, 7, 3), wall(6, 0, 6, 1);
    const auto cell = [](double column, double row)
    { return Eigen::Vector2d((column + 0.5) * kCell_m, (row + 0.5) * kCell_m); };
    return builder.inside(
        {0, 0, 7 * kCell_m, 6 * kCell_m},
        {cell(0, 0), cell(0, 2), cell(1, 2), cell(1, 0), cell(2, 0), cell(2, 2), cell(3, 2),
         cell(3, 0), cell(4, 0), cell(4, 3), cell(6, 2), cell(3, 3), cell(0, 5), cell(2, 5)});
}

const std::map<std::string, std::function<FlyWorld()>>& makers()
{
    static const std::map<std::string, std::function<FlyWorld()>> all{
        {"room", room}, {"garage", garage}, {"flat", flat}, {"maze", maze}};
    return all;
}
}  // namespace

std::vector<std::string> fly_world_names()
{
    return {"room", "garage", "flat", "maze"};
}

FlyWorld make_fly_world(const std::string& name)
{
    const auto found = makers().find(name);
    if (found == makers().end())
        throw std::invalid_argument(
            "no world '" + name + "'" + suggestion(name, fly_world_names()));
    return found->second();
}

FlyWorld door_world(double door_width_m, double wall_thickness_m)
{
    const double half_m = door_width_m / 2, front_m = 3, back_m = front_m + wall_thickness_m;
    return Builder("door")
        .box(0, -2.8, 6, 2.8)
        .box(front_m, half_m, back_m, 2.8)
        .box(front_m, -2.8, back_m, -half_m)
        .inside({1, -1, 1.4, 1}, {{100, 0}});
}
}  // namespace rtob::fly

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <room.h>
#include <rtob/core/icp.h>

#include <string>
#include <vector>

namespace rtob::test
{
/// A round thing as 60 short walls.
inline void add_circle(std::vector<Wall>& walls, double x, double y, double radius_m)
{
    constexpr int kSides = 60;
    constexpr double kStep_rad = 2 * 3.14159265358979323846 / kSides;
    for (int i = 0; i < kSides; ++i)
    {
        const double a = i * kStep_rad, b = (i + 1) * kStep_rad;
        walls.push_back(
            {x + radius_m * std::cos(a), y + radius_m * std::sin(a), x + radius_m * std::cos(b),
             y + radius_m * std::sin(b)});
    }
}

/// A world and a pose in it from which all of it can be told apart.
struct World
{
    std::string name;
    Room room;
    Pose2 pose_map_vehicle;
};

inline World room_with_circle()
{
    auto walls = room_4x3().walls();
    add_circle(walls, 1.0, 2.2, 0.3);
    return {"room_with_circle", Room(walls), {1.6, 1.2, 0.4}};
}

/// The paper's simulation (Figure 4): nothing but three cylinders.
inline World three_cylinders()
{
    std::vector<Wall> walls;
    add_circle(walls, 2.5, 0.5, 0.8);
    add_circle(walls, -1.5, 2.5, 1.0);
    add_circle(walls, -1.0, -2.5, 0.7);
    return {"three_cylinders", Room(walls), {0, 0, 1.0}};
}

inline World l_shape()
{
    return {
        "l_shape",
        Room({{0, 0, 5, 0}, {5, 0, 5, 2}, {5, 2, 2, 2}, {2, 2, 2, 4}, {2, 4, 0, 4}, {0, 4, 0, 0}}),
        {1.2, 1.1, -0.7}};
}

inline std::vector<World> worlds()
{
    return {
        {"room", room_4x3(), {1.6, 1.2, 0.4}}, room_with_circle(), three_cylinders(), l_shape()};
}

/// Sec. 2.1.3 and 2.3.1, whatever the defaults are.
inline IcpOptions paper_icp_options()
{
    IcpOptions options;
    options.iterations = 50;
    options.stop_step_m = 0;
    options.cell_points = 0;
    options.max_pair_distance_m = options.final_pair_distance_m = 0.3;
    options.metric = IcpMetric::PointToPoint;
    options.kernel = RobustKernel::None;
    return options;
}

/// What ICP is given for a guess: scan and reference seen from the guessed position, map axes.
struct Matching
{
    Points scan, reference;
    Pose2 truth;  ///< the correction to be found
};

/// All of the scan's points are in the reference, once.
inline Matching matching(const World& world, const Pose2& pose_map_vehicle_guess)
{
    const Points points_vehicle = world.room.scan_vehicle(world.pose_map_vehicle);
    const Pose2 &pose = world.pose_map_vehicle, &guess = pose_map_vehicle_guess;
    const Pose2 from_guess{pose.x - guess.x, pose.y - guess.y, pose.yaw};
    return {
        moved(points_vehicle, {0, 0, guess.yaw}),
        moved(points_vehicle, from_guess),
        {from_guess.x, from_guess.y, wrap_angle(pose.yaw - guess.yaw)}};
}
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/sim/flight.h>

using namespace rtob::sim;

namespace
{
constexpr double pi = 3.14159265358979323846;

FlightPlan square_route()
{
    FlightPlan plan;
    plan.speed_mps = 1;
    plan.route = {{{2, 0}, 1, 0}, {{2, 2}, 1, 3}, {{0, 2}, 1, 0}};
    return plan;
}
}  // namespace

TEST(SimPilot, TheTargetMovesAlongTheRouteAtItsSpeed)
{
    const Pilot pilot(square_route(), {0, 0, 1, 0, 0, 0});
    EXPECT_DOUBLE_EQ(pilot.target(0.5).at_map.x, 0.5);
    EXPECT_DOUBLE_EQ(pilot.target(0.5).vx_map_mps, 1);
    EXPECT_DOUBLE_EQ(pilot.target(3).at_map.y, 1);
    EXPECT_DOUBLE_EQ(pilot.target(6).at_map.y, 2);  // waits from 4 s to 7 s
    EXPECT_DOUBLE_EQ(pilot.target(6).vy_map_mps, 0);
    EXPECT_DOUBLE_EQ(pilot.target(8).at_map.x, 1);
    // At 9 s at (0, 2); then the round closes to (2, 0), sqrt(8) s away.
    EXPECT_NEAR(pilot.target(9 + std::sqrt(2.0)).at_map.x, 1, 1e-12);
    // The second round is the first one over again, from (2, 0) on.
    EXPECT_NEAR(pilot.target(9 + std::sqrt(8.0) + 1).at_map.y, 1, 1e-9);
}

TEST(SimPilot, WithoutRepeatItStaysAtTheEnd)
{
    auto plan = square_route();
    plan.repeat = false;
    const Pilot pilot(plan, {0, 0, 1, 0, 0, 0});
    EXPECT_DOUBLE_EQ(pilot.target(100).at_map.x, 0);
    EXPECT_DOUBLE_EQ(pilot.target(100).at_map.y, 2);
    EXPECT_DOUBLE_EQ(pilot.target(100).vx_map_mps, 0);
}

TEST(SimPilot, ClimbsOnTheWayAndNoFasterThanItMay)
{
    FlightPlan plan;
    plan.speed_mps = 1;
    plan.climb_mps = 0.5;
    plan.route = {{{1, 0}, 3, 0}};
    const Pilot pilot(plan, {0, 0, 1, 0, 0, 0});
    EXPECT_DOUBLE_EQ(pilot.target(2).altitude_m, 2);  // 2 m at 0.5 m/s take 4 s
    EXPECT_DOUBLE_EQ(pilot.target(2).at_map.x, 0.5);
    EXPECT_DOUBLE_EQ(pilot.target(2).climb_mps, 0.5);
}

TEST(SimPilot, HoversWithoutARoute)
{
    const Pilot pilot({}, {1, 2, 1, 0, 0, 0.5});
    VehicleState state;
    state.pose_map_vehicle = {1.5, 2, 1, 0, 0, 0.5};
    const auto command = pilot.command(3, state, VehicleKind::Multirotor);
    // 0.5 m too far along the map's x, seen from a vehicle that looks 0.5 rad to the left.
    EXPECT_NEAR(command.forward_mps, -0.5 * std::cos(0.5), 1e-12);
    EXPECT_NEAR(command.left_mps, 0.5 * std::sin(0.5), 1e-12);
    EXPECT_NEAR(command.yaw_rate_radps, 0, 1e-12);
}

TEST(SimPilot, BothKindsOfVehiclesStayNearTheRoute)
{
    for (const auto kind : {VehicleKind::Multirotor, VehicleKind::Differential})
        for (const auto heading : {Heading::Fixed, Heading::Ahead, Heading::Spin})
        {
            auto plan = square_route();
            plan.speed_mps = 0.5;
            plan.heading = heading;
            VehicleOptions options;
            options.kind = kind;
            const Pose3 start{0, 0, 1, 0, 0, 0};
            const Pilot pilot(plan, start);
            Vehicle vehicle(options, start, 1);
            double farthest_m = 0;
            for (int i = 0; i < 6000; ++i)
            {
                const double time_s = 0.01 * i;
                vehicle.step(0.01, pilot.command(time_s, vehicle.state(), kind));
                const auto goal = pilot.target(time_s).at_map;
                const auto& pose = vehicle.state().pose_map_vehicle;
                farthest_m = std::max(farthest_m, std::hypot(goal.x - pose.x, goal.y - pose.y));
            }
            EXPECT_LT(farthest_m, kind == VehicleKind::Multirotor ? 0.6 : 0.8);
        }
}

TEST(SimPilot, SpinsAtTheRateThatItIsGiven)
{
    FlightPlan plan;
    plan.heading = Heading::Spin;
    plan.yaw_rate_dps = 90;
    const Pilot pilot(plan, {0, 0, 1, 0, 0, 0});
    Vehicle vehicle({}, {0, 0, 1, 0, 0, 0}, 1);
    for (int i = 0; i < 1000; ++i)
        vehicle.step(0.01, pilot.command(0.01 * i, vehicle.state(), VehicleKind::Multirotor));
    EXPECT_NEAR(vehicle.state().yaw_rate_radps, pi / 2, 0.01);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rtob/sim/simulation.h>

#include "error_message.h"

using namespace rtob::sim;

namespace
{
World round_room(double radius_m)
{
    World world;
    world.objects = {{}};
    world.objects[0].name = "room";
    world.objects[0].shapes_object = {Arc{{0, 0}, radius_m}};
    return world;
}

struct Flight
{
    std::vector<LaserScan> scans;
    SensorReadings readings;
};

Flight fly(Simulation& simulation, double seconds, double dt_s, const VelocityCommand& command)
{
    Flight flight;
    while (simulation.time_s() < seconds - 1e-9)
    {
        simulation.step(dt_s, command);
        if (auto scan = simulation.takeScan()) flight.scans.push_back(*scan);
    }
    flight.readings = simulation.takeReadings();
    return flight;
}
}  // namespace

TEST(Simulation, GivesTenScansASecondAndTheOtherSensorsAtTheirRates)
{
    Simulation simulation(round_room(4), {});
    const auto flight = fly(simulation, 5, 0.01, {0.2, 0, 0, 0});
    EXPECT_EQ(flight.scans.size(), 50u);
    EXPECT_NEAR(static_cast<double>(flight.readings.imu.size()), 500, 1);
    EXPECT_NEAR(static_cast<double>(flight.readings.odometry.size()), 100, 1);
    EXPECT_NEAR(static_cast<double>(flight.readings.flow.size()), 100, 1);
    EXPECT_NEAR(static_cast<double>(flight.readings.altimeter.size()), 100, 1);
}

TEST(Simulation, SameSeedSameBeams)
{
    SimulationOptions options;
    options.vehicle.turbulence_mps2 = 1;
    const auto ranges = [&](std::uint64_t seed)
    {
        options.seed = seed;
        Simulation simulation(round_room(4), options);
        return fly(simulation, 1, 0.01, {}).scans.back().ranges_m;
    };
    EXPECT_EQ(ranges(5), ranges(5));
    EXPECT_NE(ranges(5), ranges(6));
}

TEST(Simulation, LongStepsAreTakenInParts)
{
    Simulation coarse(round_room(4), {}), fine(round_room(4), {});
    for (int i = 0; i < 10; ++i) coarse.step(0.1, {1, 0, 0.5, 0});
    for (int i = 0; i < 50; ++i) fine.step(0.02, {1, 0, 0.5, 0});
    EXPECT_NEAR(coarse.state().pose_map_vehicle.x, fine.state().pose_map_vehicle.x, 1e-9);
    EXPECT_NEAR(coarse.time_s(), 1, 1e-9);
}

TEST(Simulation, ClearanceIsThatToTheNearestThingAtItsHeight)
{
    Simulation simulation(round_room(4), {});
    EXPECT_DOUBLE_EQ(simulation.clearance_m(), 4);
    for (int i = 0; i < 100; ++i) simulation.step(0.02, {1, 0, 0, 0});
    EXPECT_NEAR(simulation.clearance_m(), 4 - simulation.state().pose_map_vehicle.x, 1e-9);
}

TEST(Simulation, RefusesAStartInsideAWall)
{
    SimulationOptions options;
    options.start_map = {3.8, 0, 1, 0, 0, 0};
    EXPECT_THAT(
        rtob::test::error_message<std::invalid_argument>([&]
                                                         { Simulation(round_room(4), options); }),
        testing::HasSubstr("starts inside a wall"));
}

TEST(Simulation, ASnapshotIsAScanOfThisInstant)
{
    SimulationOptions options;
    options.laser.noise_m = options.laser.noise_per_m = options.laser.dropout = 0;
    Simulation simulation(round_room(4), options);
    simulation.step(0.02, {});
    const auto scan = simulation.snapshot();
    EXPECT_EQ(scan.time_s, simulation.time_s());
    for (const auto range : scan.ranges_m) EXPECT_NEAR(range, 4, 1e-6);
}

TEST(Simulation, SensorsTellTheMotionUpToTheirErrors)
{
    SimulationOptions options;
    Simulation simulation(round_room(10), options);
    const auto flight = fly(simulation, 6, 0.01, {1, 0, 0.2, 0});
    const auto& end = simulation.state();
    EXPECT_NEAR(flight.readings.imu.back().yaw_rate_radps, 0.2, 5 * 0.02);
    EXPECT_NEAR(flight.readings.imu.back().az_mps2, 9.81, 1);
    // Turning to the left at 1 m/s and 0.2 rad/s pulls to the left by 0.2 m/s2; the tilt that
    // makes the vehicle do so hides it from an accelerometer.
    EXPECT_NEAR(flight.readings.flow.back().forward_mps, 1, 0.35);
    EXPECT_NEAR(flight.readings.altimeter.back().height_m, 1, 0.1);
    const auto& odometry = flight.readings.odometry.back().pose_odom_vehicle;
    EXPECT_NEAR(odometry.x, end.pose_map_vehicle.x, 0.5);
    EXPECT_NEAR(odometry.y, end.pose_map_vehicle.y, 0.5);
    EXPECT_NE(odometry.x, end.pose_map_vehicle.x);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/sim/vehicle.h>

#include <cmath>

#include "error_message.h"

using namespace rtob::sim;

namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double dt_s = 0.01;

VehicleOptions nimble()
{
    VehicleOptions options;
    options.max_acceleration_mps2 = 100;
    return options;
}

void drive(Vehicle& vehicle, double seconds, const VelocityCommand& command)
{
    for (int i = 0; i < std::lround(seconds / dt_s); ++i) vehicle.step(dt_s, command);
}
}  // namespace

TEST(SimVehicle, FollowsAVelocityAsAFirstOrderLag)
{
    Vehicle vehicle(nimble(), {0, 0, 1, 0, 0, 0}, 1);
    drive(vehicle, 0.4, {1, 0, 0, 0});
    EXPECT_NEAR(vehicle.state().vx_map_mps, 1 - std::exp(-1), 1e-9);  // one lag of 0.4 s
    drive(vehicle, 4.6, {1, 0, 0, 0});
    // The way of a lag: v t - v lag (1 - e^(-t/lag)).
    EXPECT_NEAR(vehicle.state().pose_map_vehicle.x, 5 - 0.4, 1e-3);
    EXPECT_NEAR(vehicle.state().pose_map_vehicle.y, 0, 1e-12);
}

TEST(SimVehicle, CommandsAreAlongItsOwnAxes)
{
    Vehicle vehicle(nimble(), {0, 0, 1, 0, 0, pi / 2}, 1);
    drive(vehicle, 5, {0, 1, 0, 0});
    EXPECT_NEAR(vehicle.state().vx_map_mps, -1, 1e-4);  // its left is the map's -x
    EXPECT_NEAR(vehicle.state().vy_map_mps, 0, 1e-9);
}

TEST(SimVehicle, AcceleratesNoFasterThanItMay)
{
    VehicleOptions options;
    options.max_acceleration_mps2 = 0.5;
    Vehicle vehicle(options, {0, 0, 1, 0, 0, 0}, 1);
    drive(vehicle, 2, {2, 0, 0, 0});
    EXPECT_NEAR(vehicle.state().vx_map_mps, 1, 1e-9);
    drive(vehicle, 20, {7, 0, 0, 0});
    EXPECT_NEAR(vehicle.state().vx_map_mps, 3, 1e-3);  // max_speed_mps
}

TEST(SimVehicle, TiltsIntoItsAccelerationUpToTheLimit)
{
    VehicleOptions options;
    options.max_acceleration_mps2 = 0.5;
    Vehicle vehicle(options, {0, 0, 1, 0, 0, 0}, 1);
    drive(vehicle, 1, {2, 0, 0, 0});
    EXPECT_NEAR(vehicle.state().pose_map_vehicle.pitch, std::atan(0.5 / 9.81), 1e-4);
    EXPECT_NEAR(vehicle.state().pose_map_vehicle.roll, 0, 1e-12);
    options.max_acceleration_mps2 = 5;
    Vehicle brisk(options, {0, 0, 1, 0, 0, 0}, 1);
    for (int i = 0; i < 200; ++i)
    {
        brisk.step(dt_s, {0, i < 100 ? 3.0 : -3.0, 0, 0});
        const auto& pose = brisk.state().pose_map_vehicle;
        EXPECT_LE(std::hypot(pose.roll, pose.pitch), 5 * pi / 180 + 1e-12);
        if (i == 50)
        {
            EXPECT_LT(pose.roll, -0.05);  // to the left: left side down
        }
    }
}

TEST(SimVehicle, ADifferentialDriveDoesNotSlipSideways)
{
    VehicleOptions options = nimble();
    options.kind = VehicleKind::Differential;
    options.turbulence_mps2 = 1;  // not for wheels
    Vehicle vehicle(options, {0, 0, 0.3, 0, 0, 0}, 1);
    for (int i = 0; i < 1000; ++i)
    {
        vehicle.step(dt_s, {1, 1, 0.5, 1});
        const auto& s = vehicle.state();
        const double yaw = s.pose_map_vehicle.yaw - 0.5 * dt_s * s.yaw_rate_radps;
        EXPECT_NEAR(-std::sin(yaw) * s.vx_map_mps + std::cos(yaw) * s.vy_map_mps, 0, 0.01);
    }
    EXPECT_EQ(vehicle.state().pose_map_vehicle.z, 0.3);
    EXPECT_EQ(vehicle.state().pose_map_vehicle.pitch, 0);
    EXPECT_NEAR(vehicle.state().yaw_rate_radps, 0.5, 1e-9);
}

TEST(SimVehicle, TurbulenceHasTheStrengthThatItIsGiven)
{
    VehicleOptions options = nimble();
    options.turbulence_mps2 = 0.6;
    Vehicle vehicle(options, {0, 0, 1, 0, 0, 0}, 4);
    double squares = 0;
    const int steps = 200000;
    for (int i = 0; i < steps; ++i)
    {
        vehicle.step(dt_s, {});
        squares += std::pow(vehicle.state().vx_map_mps, 2);
    }
    // A lag T under Gauss-Markov gusts of time c: RMS a T sqrt(c / (c + T)).
    EXPECT_NEAR(std::sqrt(squares / steps), 0.6 * 0.4 * std::sqrt(0.5 / 0.9), 0.015);
}

TEST(SimVehicle, SameSeedSameFlight)
{
    VehicleOptions options;
    options.turbulence_mps2 = 1;
    const auto end_of = [&](std::uint64_t seed)
    {
        Vehicle vehicle(options, {0, 0, 1, 0, 0, 0}, seed);
        drive(vehicle, 3, {});
        return vehicle.state().pose_map_vehicle.x;
    };
    EXPECT_EQ(end_of(3), end_of(3));
    EXPECT_NE(end_of(3), end_of(4));
}

TEST(SimVehicle, RefusesOptionsOutOfRangeByName)
{
    VehicleOptions options;
    options.radius_m = -1;
    EXPECT_EQ(
        rtob::test::error_message<std::invalid_argument>([&] { options.validate(); }),
        "radius_m = -1 is out of range: must be > 0");
}

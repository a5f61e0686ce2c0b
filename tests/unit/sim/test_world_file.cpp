// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rtob/sim/world_file.h>

#include <filesystem>

#include "error_message.h"
#include "temporary_file.h"

using namespace rtob::sim;
using rtob::test::TemporaryFile;

namespace
{
constexpr double pi = 3.14159265358979323846;

WorldFile world_of(const std::string& text)
{
    const TemporaryFile file(".yaml", text);
    return read_world(file.path());
}

/// The message without the file's name: "LINE: reason".
std::string complaint(const std::string& text)
{
    const TemporaryFile file(".yaml", text);
    const auto message =
        rtob::test::error_message<WorldError>([&] { (void)read_world(file.path()); });
    const auto start = file.path() + ":";
    return message.rfind(start, 0) == 0 ? message.substr(start.size()) : "no place: " + message;
}

const std::string one_wall = "objects:\n  - wall: {points: [[2, -1], [2, 1]]}\n";
}  // namespace

TEST(SimWorldFile, ReadsEveryPart)
{
    const auto file = world_of(R"(
name: test
floor_m: -1
ceiling_m: 2.5
laser: {beams: 181, field_of_view_deg: 180, clockwise: false}
vehicle: {kind: differential, radius_m: 0.2}
sensors: {imu_rate_hz: 0}
start: {at: [0.5, -0.5], yaw_deg: 90, altitude_m: 0.4}
flight:
  duration_s: 30
  heading: spin
  yaw_rate_dps: 45
  repeat: false
  route:
    - {to: [1, 0], hold_s: 2}
    - {to: [1, 1], altitude_m: 0.9}
    - {to: [0, 1]}
objects:
  - name: door
    wall: {points: [[3, 0], [4, 0]]}
    height_m: [0, 2]
    moves: [{at_s: 10, over_s: 2, turn_deg: 90}]
  - {circle: {at: [5, 5], radius_m: 0.5}, surface: {transparency: 0.5}}
  - {arc: {at: [8, 5], radius_m: 1, from_deg: -90, to_deg: 90}}
  - {box: {at: [-4, 0], size_m: [2, 1], yaw_deg: 90}, present_s: [[5, 8]]}
people:
  - {path: [[-2, 3], [2, 3]], speed_mps: 1, end_s: 100}
)");
    EXPECT_EQ(file.world.name, "test");
    EXPECT_EQ(file.world.floor_m, -1);
    EXPECT_EQ(file.world.ceiling_m, 2.5);
    EXPECT_EQ(file.simulation.laser.beams, 181);
    EXPECT_FALSE(file.simulation.laser.clockwise);
    EXPECT_EQ(file.simulation.laser.max_range_m, 6);  // the default
    EXPECT_EQ(file.simulation.vehicle.kind, VehicleKind::Differential);
    EXPECT_EQ(file.simulation.sensors.imu_rate_hz, 0);
    EXPECT_EQ(file.simulation.start_map.y, -0.5);
    EXPECT_DOUBLE_EQ(file.simulation.start_map.yaw, pi / 2);
    EXPECT_EQ(file.flight.heading, Heading::Spin);
    ASSERT_EQ(file.flight.route.size(), 3u);
    EXPECT_EQ(file.flight.route[0].altitude_m, 0.4);  // that of the start
    EXPECT_EQ(file.flight.route[2].altitude_m, 0.9);  // that of the one before
    ASSERT_EQ(file.world.objects.size(), 5u);
    const auto& door = file.world.objects[0];
    EXPECT_DOUBLE_EQ(door.pose_map_object(11).yaw, pi / 4);
    EXPECT_DOUBLE_EQ(door.pose_map_object(11).x, 3);  // about its hinge
    EXPECT_EQ(file.world.objects[1].surface.transparency, 0.5);
    EXPECT_FALSE(file.world.objects[3].isPresent(4));
    // The box stands turned: 1 m along x, 2 m along y.
    const Scene scene(file.world);
    const Beam west{{0, 0}, 0.4, {-1, 0}, 0};
    EXPECT_FALSE(scene.cast(west).met());  // it comes at 5 s
    Scene later(file.world);
    later.moveTo(6);
    EXPECT_NEAR(later.cast(west).distance_m, 3.5, 1e-12);
}

TEST(SimWorldFile, NamesLineAndReason)
{
    using testing::StartsWith;
    // The issue's list.
    EXPECT_THAT(
        complaint("name: x\nobjects:\n  - triangle: {at: [0, 0]}\n"),
        StartsWith("3: objects[0]: unknown key 'triangle'"));
    EXPECT_THAT(
        complaint("name: x\nstart: {at: [1.9, 0]}\n" + one_wall),
        StartsWith("2: start: the vehicle starts inside a wall"));
    EXPECT_EQ(
        complaint("laser:\n  rate_hz: 10\n  beams: 0\n" + one_wall),
        "3: laser: beams: beams = 0 is out of range: must be 1 to 100000");
    EXPECT_EQ(
        complaint("objects:\n  - circle:\n      radius_m: -1\n"),
        "3: objects[0].circle: radius_m: -1 is out of range: must be > 0");
    EXPECT_THAT(
        complaint("objects:\n  - box: {size_m: [1, -2]}\n"),
        StartsWith("2: objects[0].box: size_m: both numbers must be above 0"));
}

TEST(SimWorldFile, RefusesWhatItDoesNotUnderstand)
{
    using testing::HasSubstr;
    EXPECT_EQ(
        complaint("laser: {beam: 360}\n" + one_wall),
        "1: laser: unknown key 'beam'; did you mean 'beams'?");
    EXPECT_THAT(complaint("flight: {heading: sideways}\n" + one_wall), HasSubstr("spin"));
    EXPECT_THAT(
        complaint("laser: {rate_hz: ten}\n" + one_wall), HasSubstr("'ten' is not a number"));
    EXPECT_THAT(complaint("laser: {rate_hz: .nan}\n" + one_wall), HasSubstr("is not a number"));
    EXPECT_THAT(complaint("laser: 5\n" + one_wall), HasSubstr("1: laser: must hold lines"));
    EXPECT_THAT(complaint("a: [1, 2\nb: 3\n"), HasSubstr("not YAML"));
    EXPECT_THAT(complaint("name: a\nname: b\n" + one_wall), HasSubstr("2: the key 'name' stands"));
    EXPECT_THAT(complaint("name: empty\n"), HasSubstr("no objects"));
    EXPECT_THAT(complaint(""), HasSubstr("must hold lines"));
    EXPECT_THAT(
        complaint("objects:\n  - {name: thing}\n"), HasSubstr("2: objects[0]: has no shape"));
    EXPECT_THAT(
        complaint("objects:\n  - {circle: {radius_m: 1}, box: {size_m: [1, 1]}}\n"),
        HasSubstr("has both"));
    EXPECT_THAT(complaint("objects:\n  - {wall: {points: [[0, 0]]}}\n"), HasSubstr("at least two"));
    EXPECT_THAT(
        complaint("objects:\n  - {arc: {radius_m: 1, from_deg: 90, to_deg: 0}}\n"),
        HasSubstr("arcs run to the left"));
    EXPECT_THAT(
        complaint("objects:\n  - {circle: {radius_m: 1}, height_m: [2, 1]}\n"),
        HasSubstr("the second must be above the first"));
    EXPECT_THAT(
        complaint(one_wall + "people:\n  - {path: [[0, 0]]}\n"), HasSubstr("at least two points"));
    EXPECT_THAT(
        rtob::test::error_message<WorldError>([] { (void)read_world("/nowhere/x.yaml"); }),
        HasSubstr("/nowhere/x.yaml: no such file"));
}

TEST(SimWorldFile, RefusesARouteThroughAWall)
{
    EXPECT_EQ(
        complaint("flight:\n  route:\n    - {to: [0, 1]}\n    - {to: [4, -0.5]}\n" + one_wall),
        "2: flight.route: the way to waypoint 2 goes through a wall, 2.136001 m after the one "
        "before");
}

TEST(SimWorldFile, TheWorldsThatComeWithTheProgramAreSound)
{
    int worlds = 0;
    for (const auto& entry : std::filesystem::directory_iterator(RTOB_WORLDS))
        if (entry.path().extension() == ".yaml")
        {
            const auto file = read_world(entry.path().string());
            // A sound flight ends without touching anything. The first 20 s tell most of it.
            Simulation simulation(file.world, file.simulation);
            const Pilot pilot(file.flight, file.simulation.start_map);
            while (simulation.time_s() < 20)
                simulation.step(
                    0.02,
                    pilot.command(
                        simulation.time_s(), simulation.state(), file.simulation.vehicle.kind));
            EXPECT_GT(simulation.clearance_m(), 0.1) << entry.path();
            ++worlds;
        }
    EXPECT_GE(worlds, 3);
}

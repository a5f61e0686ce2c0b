// SPDX-License-Identifier: BSD-3-Clause
// `rtob-slam simulate` as a process: same seed, same bytes; logs that others read; plain refusals.
#include <gmock/gmock.h>

#include <filesystem>
#include <set>

#include "rtob_slam_run.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

const std::string worlds = RTOB_SOURCE_DIR "/share/worlds/";

class Simulate : public RunFixture
{
 protected:
    ProgramResult simulate(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), "simulate");
        return run_program(RTOB_PROGRAM, arguments);
    }
    std::string simulated(
        const std::string& world, const std::string& name,
        const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> arguments{worlds + world, "-o", folder_.file(name)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto result = simulate(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return folder_.file(name);
    }
};

TEST_F(Simulate, SameSeedSameBytes)
{
    const std::vector<std::string> first{"--seed", "3", "--duration", "5"};
    const auto a = simulated("room.yaml", "a.rawlog", first);
    const auto b = simulated("room.yaml", "b.rawlog", first);
    const auto c = simulated("room.yaml", "c.rawlog", {"--seed", "4", "--duration", "5"});
    EXPECT_GT(file_content(a).size(), 10000u);
    EXPECT_EQ(file_content(a), file_content(b));
    EXPECT_NE(file_content(a), file_content(c));
    EXPECT_EQ(file_content(folder_.file("a.truth.tum")), file_content(folder_.file("b.truth.tum")));
}

TEST_F(Simulate, TheLogHoldsObservationsOnlyAndTheTruthAllItsScans)
{
    const auto log = simulated("garage.yaml", "log.rawlog", {"--duration", "4"});
    const auto reader = open_log(log);
    std::set<std::string> labels;
    std::vector<double> stamps;
    while (const auto entry = reader->next())
    {
        ASSERT_TRUE(entry->observation);
        labels.insert(entry->observation->sensorLabel);
        if (entry->observation->sensorLabel == "LASER")
            stamps.push_back(mrpt::Clock::toDouble(entry->observation->timestamp));
    }
    EXPECT_EQ(labels, (std::set<std::string>{"ALTIMETER", "FLOW", "IMU", "LASER", "odometry"}));
    const auto truth = read_tum(folder_.file("log.truth.tum"));
    ASSERT_EQ(truth.size(), 40u);
    ASSERT_EQ(stamps.size(), 40u);
    for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(truth[i].time_s, stamps[i], 1e-6);
}

TEST_F(Simulate, ARunFollowsTheTruth)
{
    const auto log = simulated("room.yaml", "log.rawlog", {"--duration", "10", "--laser-only"});
    ASSERT_EQ(run(log).exit_code, 0);
    const auto truth = read_tum(folder_.file("log.truth.tum"));
    const auto estimate = trajectory();
    ASSERT_EQ(estimate.size(), truth.size());
    const Pose2 way = between(truth.front().pose, truth.back().pose);
    const Pose2 way_estimate = between(estimate.front().pose, estimate.back().pose);
    EXPECT_NEAR(way_estimate.x, way.x, 0.03);
    EXPECT_NEAR(way_estimate.y, way.y, 0.03);
    EXPECT_NEAR(way_estimate.yaw, way.yaw, 0.01);
}

TEST_F(Simulate, MrptReadsTheLog)
{
    if (std::system("command -v rawlog-edit >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "rawlog-edit is not installed (package mrpt-apps)";
    const auto log = simulated("cylinders.yaml", "log.rawlog", {"--duration", "3"});
    const auto result = run_program("/usr/bin/rawlog-edit", {"--info", "-i", log});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("LASER"));
    EXPECT_THAT(result.out, HasSubstr("30"));
}

TEST_F(Simulate, RefusalsNameFileLineAndReason)
{
    const auto refused = [&](const std::string& text)
    {
        const auto world = folder_.write("bad.yaml", text);
        const auto log = folder_.file("bad.rawlog");
        const auto result = simulate({world, "-o", log});
        EXPECT_EQ(result.exit_code, 1) << text;
        EXPECT_FALSE(std::filesystem::exists(log));
        return result.err;
    };
    const std::string wall = "objects:\n  - wall: {points: [[2, -1], [2, 1]]}\n";
    EXPECT_THAT(refused("objects:\n  - cube: {}\n"), HasSubstr("bad.yaml:2: objects[0]: unknown"));
    EXPECT_THAT(refused("start: {at: [2, 0]}\n" + wall), HasSubstr("bad.yaml:1: start: the veh"));
    EXPECT_THAT(refused("laser:\n  beams: 0\n" + wall), HasSubstr("bad.yaml:2: laser: beams"));
    EXPECT_THAT(
        refused("objects:\n  - circle: {radius_m: -2}\n"), HasSubstr("bad.yaml:2: objects[0]"));
    EXPECT_EQ(simulate({folder_.file("none.yaml"), "-o", folder_.file("x")}).exit_code, 1);
    EXPECT_EQ(simulate({worlds + "room.yaml"}).exit_code, 2);
    EXPECT_EQ(
        simulate({worlds + "room.yaml", "-o", folder_.file("x"), "--rate", "-5"}).exit_code, 2);
}

TEST_F(Simulate, ReplacesALogOnlyWhenTold)
{
    const auto log = simulated("room.yaml", "log.rawlog", {"--duration", "1"});
    const auto result = simulate({worlds + "room.yaml", "-o", log, "--duration", "1"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("--overwrite"));
    simulated("room.yaml", "log.rawlog", {"--duration", "1", "--overwrite"});
}
}  // namespace
}  // namespace rtob::test

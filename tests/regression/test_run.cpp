// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/serialization/CArchive.h>
#include <rtob/map/rtob_map.h>

#include "near_pose.h"
#include "rtob_slam_run.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class Run : public RunFixture
{
};

/// A room of another shape: nothing of it fits room_4x3().
Room other_room()
{
    return Room({{-6, -2, 5, -5}, {5, -5, 7, 4}, {7, 4, 0, 7}, {0, 7, -6, -2}});
}

TEST_F(Run, FollowsTheVehicleAndWritesEveryFile)
{
    const auto result = run(drive_log());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, AllOf(HasSubstr(results()), HasSubstr("\n40 scans, 0 lost, ")));

    const auto poses = trajectory();
    ASSERT_EQ(poses.size(), 40u);
    for (int k = 0; k < 40; ++k)
    {
        const auto& [time_s, pose] = poses[static_cast<std::size_t>(k)];
        EXPECT_NEAR(time_s, drive_start_s + k * drive_step_s, 1e-6) << k;
        EXPECT_THAT(pose, IsNearPose(pose_on_circle_map(k), 0.02, 0.01)) << k;
    }
    for (const char* name :
         {"poses.csv", "timing.csv", "map.pgm", "map.yaml", "map.ply", "map.rtob", "map.png",
          "summary.txt", "summary.json", "config.effective.ini"})
        EXPECT_GT(std::filesystem::file_size(results() + "/" + name), 0u) << name;
    EXPECT_FALSE(std::filesystem::exists(results() + "/map.simplemap"));
    for (const auto& entry : std::filesystem::directory_iterator(results()))
        EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

TEST_F(Run, FollowsTheVehicleByThePapersMethodToo)
{
    const auto result =
        run(drive_log(), {"-c", RTOB_SOURCE_DIR "/config/paper.ini", "--no-odometry"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto poses = trajectory();
    ASSERT_EQ(poses.size(), 40u);
    for (int k = 0; k < 40; ++k)
        EXPECT_THAT(
            poses[static_cast<std::size_t>(k)].pose, IsNearPose(pose_on_circle_map(k), 0.03, 0.02))
            << k;
}

TEST_F(Run, SaysTheSameInSummaryAndOnTheTerminal)
{
    const auto result = run(drive_log());
    const auto figures = summary();
    EXPECT_EQ(figures["scans"]["total"], 40);
    EXPECT_EQ(figures["scans"]["used"], 40);
    EXPECT_EQ(figures["states"]["TRACKING"], 40);
    EXPECT_EQ(figures["input"]["odometry_used"], true);
    EXPECT_NEAR(figures["drive"]["duration_s"], 39 * drive_step_s, 1e-3);
    EXPECT_NEAR(figures["drive"]["path_m"], 39 * 2 * 0.5 * std::sin(0.05), 0.05);  // 39 chords
    const std::string line = figures["line"];
    EXPECT_THAT(result.out, HasSubstr(line + "\n"));
    EXPECT_THAT(file_content(results() + "/summary.txt"), HasSubstr(line + "\n"));
}

TEST_F(Run, IsRepeatableToTheByteAndTheSeedMatters)
{
    const auto log = drive_log();
    // So few points that the draw has to leave some out.
    const std::vector<std::string> few{"--set", "Draw.points=200", "--seed"};
    const auto with_seed = [&](const std::string& name, const std::string& seed)
    {
        auto flags = few;
        flags.push_back(seed);
        EXPECT_EQ(run_into(results(name), log, flags).exit_code, 0);
    };
    with_seed("a", "7");
    with_seed("b", "7");
    with_seed("c", "8");
    for (const char* name :
         {"/trajectory.tum", "/trajectory_final.tum", "/map.rtob", "/map.ply", "/map.pgm",
          "/poses.csv"})
        EXPECT_EQ(file_content(results("a") + name), file_content(results("b") + name)) << name;
    for (const char* name : {"/trajectory.tum", "/map.rtob", "/map.ply"})
        EXPECT_NE(file_content(results("a") + name), file_content(results("c") + name)) << name;
}

TEST_F(Run, TheEffectiveConfigurationRepeatsTheRun)
{
    const auto log = drive_log();
    run_into(results("a"), log, {"--seed", "5", "--set", "Draw.points=200", "--no-odometry"});
    const auto again = run_into(results("b"), log, {"-c", results("a") + "/config.effective.ini"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    for (const char* name : {"/trajectory.tum", "/map.rtob", "/config.effective.ini"})
        EXPECT_EQ(file_content(results("a") + name), file_content(results("b") + name)) << name;
    EXPECT_EQ(summary("b")["input"]["odometry_used"], false);
}

TEST_F(Run, StoresAMapThatMrptReadsBack)
{
    run(drive_log());
    mrpt::io::CFileGZInputStream file(results() + "/map.rtob");
    RtobMap map;
    mrpt::serialization::archiveFrom(file) >> map;
    EXPECT_EQ(map.scans().size(), 40u);
    EXPECT_EQ(map.size(), summary()["map"]["points"].get<std::size_t>());
    EXPECT_THAT(map.scans().pose(39), IsNearPose(pose_on_circle_map(39), 0.02, 0.01));
}

TEST_F(Run, WritesASimplemapOnRequest)
{
    EXPECT_EQ(run(drive_log(), {"--simplemap"}).exit_code, 0);
    mrpt::maps::CSimpleMap simple_map;
    ASSERT_TRUE(simple_map.loadFromFile(results() + "/map.simplemap"));
    EXPECT_EQ(simple_map.size(), 40u);
}

TEST_F(Run, SkipAndFirstCountScans)
{
    EXPECT_EQ(run(drive_log(), {"--skip", "10", "--first", "5"}).exit_code, 0);
    const auto poses = trajectory();
    ASSERT_EQ(poses.size(), 5u);
    EXPECT_NEAR(poses[0].time_s, drive_start_s + 10 * drive_step_s, 1e-6);
    EXPECT_THAT(poses[0].pose, IsNearPose(Pose2{}, 1e-9, 1e-9));
    EXPECT_EQ(summary()["scans"]["total"], 5);
}

TEST_F(Run, RefusesAFolderThatHoldsSomethingUnlessTold)
{
    const auto log = drive_log();
    std::filesystem::create_directories(results());
    const std::string notes = results() + "/notes.txt", stale = results() + "/map.simplemap";
    std::ofstream(notes) << "mine";
    std::ofstream(stale) << "old";
    const auto refused = run(log);
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.err, AllOf(HasSubstr(results()), HasSubstr("--overwrite")));
    EXPECT_FALSE(std::filesystem::exists(results() + "/trajectory.tum"));

    EXPECT_EQ(run(log, {"--overwrite"}).exit_code, 0);
    EXPECT_EQ(file_content(notes), "mine");
    EXPECT_FALSE(std::filesystem::exists(stale)) << "a result of an earlier run";
}

TEST_F(Run, SaysWhereItCannotWrite)
{
    const auto file = folder_.write("file", "");
    const auto result = run_into(file + "/below", drive_log());
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, AllOf(HasSubstr(file + "/below"), HasSubstr("-o")));
}

TEST_F(Run, EndsLostInARoomThatItHasNeverSeen)
{
    LogObjects log;
    for (int k = 0; k < 20; ++k) log.push_back(scan_on_circle(k));
    for (int k = 20; k < 60; ++k) log.push_back(scan_on_circle(k, other_room()));
    const auto result = run(write_log("jump.rawlog", log));
    EXPECT_EQ(result.exit_code, 3) << result.out;
    EXPECT_THAT(
        result.err, AllOf(StartsWith("rtob-slam: lost at the end"), HasSubstr("poses.csv")));
    EXPECT_EQ(trajectory().size(), 60u) << "a lost vehicle has a prediction";
    EXPECT_EQ(summary()["states"]["times_lost"], 1);
    EXPECT_GT(summary()["states"]["LOST"], 0);
}

TEST_F(Run, ASignalEndsItAndWritesWhatThereIs)
{
    for (const int signal : {SIGINT, SIGTERM})
    {
        // Long enough for a minute: the same drive over and over.
        std::ofstream log(folder_.file("long.rawlog"), std::ios::binary);
        const auto bytes = rawlog_bytes(drive_objects(40));
        for (int k = 0; k < 1000; ++k) log << bytes;
        log.close();
        const auto name = std::to_string(signal);
        RunningProgram program(
            RTOB_PROGRAM, {"run", folder_.file("long.rawlog"), "-o", results(name)});
        while (!std::filesystem::exists(results(name) + "/poses.csv.part")) usleep(10'000);
        usleep(100'000);
        program.send(signal);
        program.send(signal);  // as timeout(1) does
        const auto result = program.wait();
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_THAT(result.err, AllOf(HasSubstr("ended by a signal"), HasSubstr(results(name))));
        const auto poses = trajectory(name);
        EXPECT_GE(poses.size(), 1u);
        EXPECT_LT(poses.size(), 40'000u);
        EXPECT_EQ(summary(name)["scans"]["total"], poses.size());
        EXPECT_TRUE(std::filesystem::exists(results(name) + "/map.png"));
    }
}

TEST_F(Run, MapsTheMalagaLog)
{
    const std::string log =
        "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";
    if (!std::filesystem::exists(log)) GTEST_SKIP() << "Debian's mrpt-common is not installed";
    const auto result = run(log);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto figures = summary();
    EXPECT_EQ(figures["scans"]["total"], 225);
    EXPECT_EQ(figures["states"]["TRACKING"], 225);
    // The path that MRPT's own icp-slam finds is 77 m long and ends here.
    EXPECT_NEAR(figures["drive"]["path_m"], 77, 1);
    EXPECT_THAT(trajectory().back().pose, IsNearPose(Pose2{4.26, -18.48, -1.528}, 0.15, 0.02));
}
}  // namespace
}  // namespace rtob::test

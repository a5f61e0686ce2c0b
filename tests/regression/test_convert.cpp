// SPDX-License-Identifier: BSD-3-Clause
// `rtob-slam convert` as a process: what it writes serves `run` and MRPT's own programs.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "rtob_slam_run.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

class Convert : public RunFixture
{
 protected:
    ProgramResult convert(const std::vector<std::string>& arguments) const
    {
        std::vector<std::string> all{"convert"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return run_program(RTOB_PROGRAM, all);
    }
    std::string converted(const std::string& log, const std::string& name) const
    {
        const auto result = convert({log, folder_.file(name)});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.out, HasSubstr(name));
        return folder_.file(name);
    }
    std::string trajectory_of(const std::string& log, const std::string& results_name) const
    {
        const auto result = run_into(results(results_name), log);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return file_content(results(results_name) + "/trajectory.tum");
    }
};

/// Rawlog -> CARMEN -> rawlog: no rounding is left that could change a point.
TEST_F(Convert, ARunOnTheConvertedLogGivesTheSameBytes)
{
    const auto carmen = converted(drive_log(), "drive.clf.gz");
    const auto rawlog = converted(carmen, "back.rawlog");
    const auto original = trajectory_of(drive_log(), "a");
    EXPECT_FALSE(original.empty());
    EXPECT_EQ(trajectory_of(carmen, "b"), original);
    EXPECT_EQ(trajectory_of(rawlog, "c"), original);
}

TEST_F(Convert, PosesGoThereAndBack)
{
    ASSERT_EQ(run(drive_log()).exit_code, 0);
    const auto rawlog = converted(results() + "/trajectory.tum", "poses.rawlog");
    const auto back = read_tum(converted(rawlog, "poses.tum")), original = trajectory();
    ASSERT_EQ(back.size(), original.size());
    for (std::size_t i = 0; i < back.size(); ++i)
    {
        EXPECT_EQ(back[i].time_s, original[i].time_s);
        EXPECT_EQ(back[i].pose.x, original[i].pose.x);
        EXPECT_EQ(back[i].pose.y, original[i].pose.y);
        EXPECT_NEAR(
            back[i].pose.yaw, original[i].pose.yaw, 4e-9);  // nine decimals of half the turn
    }
}

TEST_F(Convert, EvalTakesThePosesOfARawlogAsTruth)
{
    ASSERT_EQ(run(drive_log()).exit_code, 0);
    const auto tum = results() + "/trajectory.tum";
    const auto rawlog = converted(tum, "poses.rawlog");
    for (const auto& [estimate, reference] : {std::pair(tum, rawlog), std::pair(rawlog, tum)})
    {
        const auto result =
            run_program(RTOB_PROGRAM, {"eval", estimate, reference, "--align", "none", "--json"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const auto json = nlohmann::json::parse(result.out);
        EXPECT_EQ(json["matched_poses"], 40);
        EXPECT_LT(json["ate"]["translation_m"]["max"], 1e-9);
        EXPECT_LT(json["ate"]["rotation_deg"]["max"], 1e-6);  // nine decimals of a quaternion
    }
}

TEST_F(Convert, SaysWhatIsWrong)
{
    const auto no_target = convert({drive_log(), folder_.file("a.txt")});
    EXPECT_EQ(no_target.exit_code, 2);
    EXPECT_THAT(no_target.err, AllOf(HasSubstr("*.rawlog"), HasSubstr("--to")));
    EXPECT_EQ(convert({drive_log()}).exit_code, 2);
    EXPECT_EQ(convert({drive_log(), "a.log", "--max-range", "-1"}).exit_code, 2);

    const auto existing = convert({drive_log(), folder_.write("a.log", "precious")});
    EXPECT_EQ(existing.exit_code, 1);
    EXPECT_THAT(existing.err, HasSubstr("--overwrite"));

    const std::string bytes = rawlog_bytes(drive_objects(3));
    const auto damaged = folder_.write("damaged.rawlog", bytes.substr(0, bytes.size() - 10));
    const auto part = convert({damaged, folder_.file("part.log"), "--keep-part"});
    EXPECT_EQ(part.exit_code, 1);
    EXPECT_THAT(part.err, AllOf(HasSubstr("truncated"), HasSubstr("What comes before is in")));
    EXPECT_TRUE(std::filesystem::exists(folder_.file("part.log")));
}

/// MRPT's own programs on a CARMEN log, by way of our rawlog.
class ConvertForMrpt : public Convert
{
 protected:
    void SetUp() override
    {
        for (const char* program : {rawlog_edit, icp_slam})
            if (!std::filesystem::exists(program))
                GTEST_SKIP() << program << " is missing (package mrpt-apps)";
    }
    /// icp-slam's path: lines "step x y yaw".
    std::string icp_slam_path(const std::string& log) const
    {
        const std::string ini = folder_.write(
            "icp.ini", "[MappingApplication]\nlogOutput_dir=" + folder_.file("icp") +
                           "\nrawlog_offset=0\nLOG_FREQUENCY=0\nSAVE_3D_SCENE=0\n"
                           "SAVE_POSE_LOG=0\nSHOW_PROGRESS_3D_REAL_TIME=0\n"
                           "CAMERA_3DSCENE_FOLLOWS_ROBOT=0\nlocalizationLinDistance=0\n"
                           "localizationAngDistance=0\ninsertionLinDistance=0.1\n"
                           "insertionAngDistance=5\nminICPgoodnessToAccept=0.4\n"
                           "matchAgainstTheGrid=0\npointsMap_count=1\n");
        const auto result = run_program(icp_slam, {ini, log});
        EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
        return file_content(folder_.file("icp") + "/log_estimated_path.txt");
    }

    static constexpr const char* rawlog_edit = "/usr/bin/rawlog-edit";
    static constexpr const char* icp_slam = "/usr/bin/icp-slam";
};

TEST_F(ConvertForMrpt, RawlogEditFindsScansOdometryAndStamps)
{
    const auto rawlog = converted(converted(drive_log(), "drive.clf"), "back.rawlog");
    const auto info = run_program(rawlog_edit, {"--info", "-i", rawlog});
    EXPECT_EQ(info.exit_code, 0) << info.err;
    EXPECT_THAT(
        info.out,
        AllOf(
            HasSubstr("Overall number of objects         : 80"),
            HasSubstr("Observations format               : Yes"),
            HasSubstr("Earliest timestamp                : 1000.25"),
            HasSubstr("laser_front /     40 /10.000"), HasSubstr("odometry /     40 /10.000")));
}

TEST_F(ConvertForMrpt, IcpSlamTakesTheSamePath)
{
    const auto original = icp_slam_path(drive_log());
    EXPECT_GT(original.size(), 1000U);
    const auto rawlog = converted(converted(drive_log(), "drive.clf"), "back.rawlog");
    EXPECT_EQ(icp_slam_path(rawlog), original);
}
}  // namespace
}  // namespace rtob::test

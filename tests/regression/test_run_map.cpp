// SPDX-License-Identifier: BSD-3-Clause
// rtob-slam run in the map of an earlier run.
#include <gmock/gmock.h>

#include <filesystem>

#include "rtob_slam_run.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

class RunInMap : public RunFixture
{
 protected:
    /// Makes the map of the drive, in results/first.
    void SetUp() override
    {
        log_ = drive_log();
        ASSERT_EQ(run_into(results("first"), log_, {"--quiet"}).exit_code, 0);
        map_ = results("first") + "/map.rtob";
    }
    [[nodiscard]] ProgramResult runInMap(const std::vector<std::string>& more) const
    {
        std::vector<std::string> flags{"--quiet", "--overwrite", "--map", map_};
        flags.insert(flags.end(), more.begin(), more.end());
        return run(log_, flags);
    }

    std::string log_, map_;
};

TEST_F(RunInMap, LocalisingLeavesTheMapAsItIs)
{
    const std::string before = file_content(map_);
    const auto result = runInMap({"--localize", "--initial-pose", "0,0,0"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto map = summary().at("map");
    EXPECT_EQ(map.at("checksum"), map.at("checksum_before"));
    EXPECT_EQ(map.at("checksum"), summary("first").at("map").at("checksum"));
    EXPECT_FALSE(std::filesystem::exists(results() + "/map.rtob"));
    EXPECT_EQ(file_content(map_), before);
    EXPECT_EQ(trajectory().size(), trajectory("first").size());
}

TEST_F(RunInMap, WithoutLocalisingItGrows)
{
    const auto result = runInMap({"--initial-pose", "0,0,0"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_GT(summary().at("map").at("scans"), summary("first").at("map").at("scans"));
    EXPECT_TRUE(std::filesystem::exists(results() + "/map.rtob"));
}

TEST_F(RunInMap, WithoutAPoseTheVehicleIsFound)
{
    const auto result = runInMap({"--localize", "--no-odometry"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto states = summary().at("states");
    EXPECT_EQ(states.at("final"), "TRACKING");
    EXPECT_LE(states.at("LOST").get<int>() + states.at("RELOCALISING").get<int>(), 10);
}

TEST_F(RunInMap, ADamagedMapIsRefused)
{
    const std::string whole = file_content(map_);
    map_ = folder_.write("cut.rtob", whole.substr(0, whole.size() - 9));
    const auto result = runInMap({});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(
        result.err,
        AllOf(HasSubstr("cut.rtob"), HasSubstr("cut short or damaged"), HasSubstr("Copy")));
    EXPECT_FALSE(std::filesystem::exists(results()));
}

TEST_F(RunInMap, FlagsThatMakeNoSenseAreWrongUsage)
{
    const auto without_map = run(log_, {"--localize"});
    EXPECT_EQ(without_map.exit_code, 2);
    EXPECT_THAT(without_map.err, HasSubstr("no map to localise in"));
    const auto bad_pose = runInMap({"--initial-pose", "here"});
    EXPECT_EQ(bad_pose.exit_code, 2);
    EXPECT_THAT(bad_pose.err, HasSubstr("write x,y,yaw"));
}
}  // namespace
}  // namespace rtob::test

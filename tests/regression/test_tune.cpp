// SPDX-License-Identifier: BSD-3-Clause
// `rtob-slam tune` as a process: a suggestion that `run` takes, and plain refusals.
#include <gmock/gmock.h>

#include <filesystem>

#include "rtob_slam_run.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

class Tune : public RunFixture
{
 protected:
    ProgramResult tune(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), "tune");
        return run_program(RTOB_PROGRAM, arguments);
    }
    const std::string world_ = RTOB_SOURCE_DIR "/share/worlds/room.yaml";
};

TEST_F(Tune, WritesASuggestionThatRunTakes)
{
    const auto folder = folder_.file("tuned");
    const auto result = tune(
        {world_, "-o", folder, "--seeds", "1", "--first", "40", "--budget-ms", "10000",
         "--no-odometry"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("Draw.points"));
    // With all the time of the world, the largest values that were tried.
    const auto ini = file_content(folder + "/tune.ini");
    EXPECT_THAT(ini, HasSubstr("points = 5400"));
    EXPECT_THAT(ini, HasSubstr("iterations = 50"));
    EXPECT_THAT(file_content(folder + "/Draw.points.svg"), HasSubstr("<svg"));
    EXPECT_THAT(file_content(folder + "/tune.md"), HasSubstr("| suggested |"));
    const auto run_result =
        run(folder + "/flight-1.rawlog", {"-c", folder + "/tune.ini", "--first", "20"});
    EXPECT_EQ(run_result.exit_code, 0) << run_result.err;
}

TEST_F(Tune, SaysWhatIsMissing)
{
    const auto log = drive_log();
    const auto result = tune({log, "-o", folder_.file("tuned")});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("--truth"));
    EXPECT_FALSE(std::filesystem::exists(folder_.file("tuned")));
    EXPECT_EQ(tune({world_, "--budget-ms", "0"}).exit_code, 2);
    EXPECT_EQ(tune({world_, "--set", "Draw.dots=5"}).exit_code, 2);
}
}  // namespace
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

ProgramResult rtob_slam(const std::vector<std::string>& arguments)
{
    return run_program(RTOB_PROGRAM, arguments);
}

void expect_usage_error(const std::vector<std::string>& arguments, const std::string& message)
{
    const auto result = rtob_slam(arguments);
    EXPECT_EQ(result.exit_code, 2) << message;
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_EQ(result.out, "");
}

TEST(CommandLine, HelpIsThereForAllAndEndsWell)
{
    const std::vector<std::vector<std::string>> all{
        {"--help"}, {"run", "--help"}, {"eval", "--help"}, {"options", "--help"}};
    for (const auto& arguments : all)
    {
        const auto result = rtob_slam(arguments);
        EXPECT_EQ(result.exit_code, 0) << arguments[0];
        EXPECT_THAT(result.out, HasSubstr("Usage:")) << arguments[0];
        EXPECT_EQ(result.err, "");
    }
    EXPECT_THAT(
        rtob_slam({"run", "/nowhere/log", "-o", "/nowhere/results", "--help"}).out,
        AllOf(HasSubstr("--no-odometry"), HasSubstr("Exit codes")));
}

TEST(CommandLine, TellsItsVersion)
{
    EXPECT_THAT(rtob_slam({"--version"}).out, StartsWith("rtob-slam "));
}

TEST(CommandLine, RefusesWhatItDoesNotKnowWithASuggestion)
{
    expect_usage_error({}, "Usage:");
    expect_usage_error({"rum", "log"}, "unknown verb 'rum'; did you mean 'run'?");
    expect_usage_error({"run"}, "LOG");
    expect_usage_error({"run", "log", "--sed", "1"}, "unknown flag --sed; did you mean '--seed'?");
    expect_usage_error({"run", "log", "second"}, "second");
    expect_usage_error({"eval", "a.tum"}, "REF");
}

TEST(CommandLine, RefusesBadValuesOfFlags)
{
    expect_usage_error({"run", "log", "--seed", "-1"}, "--seed: key seed: '-1' is not");
    expect_usage_error({"run", "log", "--density", "revisitt"}, "did you mean 'revisit'?");
    expect_usage_error({"run", "log", "--first", "ten"}, "--first: 'ten' is not");
    expect_usage_error({"run", "log", "--first", "0"}, "--first: must be at least 1");
    expect_usage_error({"run", "log", "--skip", "1.5"}, "--skip: '1.5' is not");
    expect_usage_error({"run", "log", "--set", "Draw.points"}, "write --set Section.key=value");
    expect_usage_error({"run", "log", "--set", "Drow.points=9"}, "did you mean 'Draw'?");
    expect_usage_error({"run", "log", "--set", "Draw.pointz=9"}, "did you mean 'points'?");
    expect_usage_error({"run", "log", "--set", "Draw.points=0"}, "[Draw]");
}

TEST(CommandLine, OptionsPrintsAnIniThatIsValid)
{
    const TemporaryFolder folder;
    const auto ini = rtob_slam({"options"});
    EXPECT_EQ(ini.exit_code, 0);
    EXPECT_THAT(ini.out, AllOf(StartsWith("[Run]\n"), HasSubstr("\n[Icp]\n")));
    const auto result = rtob_slam({"run", "/nowhere/log", "-c", folder.write("all.ini", ini.out)});
    EXPECT_THAT(result.err, HasSubstr("/nowhere/log: ")) << "the .ini itself is fine";
    EXPECT_THAT(
        rtob_slam({"options", "--markdown"}).out,
        AllOf(StartsWith("# Options\n"), HasSubstr("\n## [Icp]\n"), HasSubstr("| `seed` | `1` |")));
}

/// The vehicle drives 1 m, then 2 m; the relations say 1 m and 1.9 m.
TEST(CommandLine, EvalPrintsTheFiguresOfRelations)
{
    const TemporaryFolder folder;
    const auto trajectory =
        folder.write("a.tum", "1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n3 3 0 0 0 0 0 1\n");
    const auto relations =
        folder.write("a.relations", "1 2 1 0 0 0 0 0\n2 3 1.9 0 0 0 0 0\n3 9 1 0 0 0 0 0\n");
    const auto text = rtob_slam({"eval", trajectory, relations});
    EXPECT_EQ(text.exit_code, 0) << text.err;
    EXPECT_THAT(
        text.out, AllOf(
                      HasSubstr("2 relations used, 1 name a time without a pose"),
                      HasSubstr("0.0500 +- 0.0500 m\n"), HasSubstr("from 2.000000 to 3.000000")));

    const auto json =
        nlohmann::json::parse(rtob_slam({"eval", trajectory, relations, "--json"}).out);
    EXPECT_EQ(json["relations_used"], 2);
    EXPECT_EQ(json["relations_without_pose"], 1);
    EXPECT_NEAR(json["translation_m"]["mean"], 0.05, 1e-9);
    EXPECT_NEAR(json["worst"][0]["translation_m"], 0.1, 1e-9);
    EXPECT_EQ(json["worst"][0]["t1_s"], 2.0);
}

TEST(CommandLine, EvalNamesTheFileThatIsWrong)
{
    const TemporaryFolder folder;
    const auto trajectory = folder.write("a.tum", "1 0 0 0 0 0 0 1\n");
    const auto bad = folder.write("bad", "nonsense\n");
    for (const auto& [first, second] : {std::pair(trajectory, bad), std::pair(bad, trajectory)})
    {
        const auto result = rtob_slam({"eval", first, second});
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_THAT(result.err, AllOf(HasSubstr(bad), HasSubstr("line 1")));
    }
}
}  // namespace
}  // namespace rtob::test

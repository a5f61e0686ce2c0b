// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <sstream>

#include "rtob_slam_run.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

/// A small vehicle, for a room of 4 m x 3 m.
const std::vector<std::string> small{
    "--guard", "--set", "VehicleLimits.radius_m=0.2", "--set", "Guard.no_return_is_free=true"};

struct Line
{
    double wish_ahead_mps, command_ahead_mps, distance_m;
    std::string reason;
};

class RunGuard : public RunFixture
{
 protected:
    std::vector<Line> guarded(std::vector<std::string> more) const
    {
        more.insert(more.begin(), small.begin(), small.end());
        const auto result = run(drive_log(), more);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        std::istringstream file(file_content(results() + "/guard.csv"));
        std::string text;
        std::getline(file, text);
        EXPECT_EQ(text.substr(0, 24), "stamp_s,wish_ahead_mps,w");
        std::vector<Line> lines;
        while (std::getline(file, text))
        {
            std::vector<std::string> cells;
            std::istringstream row(text);
            for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
            EXPECT_EQ(cells.size(), 8u) << text;
            lines.push_back(
                {std::stod(cells[1]), std::stod(cells[3]), std::stod(cells[7]), cells[5]});
        }
        return lines;
    }
};

// 5 cm a scan of 0.1 s along a circle, at least 0.7 m from all walls: nothing to object to.
TEST_F(RunGuard, LetsPassWhatWasDrivenSafely)
{
    const auto lines = guarded({});
    ASSERT_EQ(lines.size(), 40u);
    EXPECT_EQ(lines[0].reason, "NO_DATA");  // no motion known yet
    for (std::size_t i = 4; i < lines.size(); ++i)
    {
        EXPECT_EQ(lines[i].reason, "FREE") << i;
        EXPECT_NEAR(lines[i].wish_ahead_mps, 0.5, 0.1) << i;
        EXPECT_EQ(lines[i].command_ahead_mps, lines[i].wish_ahead_mps) << i;
    }
    EXPECT_EQ(summary()["guard"]["decisions"], 40);
    EXPECT_GE(summary()["guard"]["FREE"], 36);
}

TEST_F(RunGuard, LimitsAWishThatIsTooFast)
{
    const auto lines = guarded({"--wish", "2,0"});
    ASSERT_EQ(lines.size(), 40u);
    std::size_t limited = 0;
    for (const Line& line : lines)
    {
        EXPECT_EQ(line.wish_ahead_mps, 2);
        limited += line.reason == "SLOWED" || line.reason == "GUIDED" || line.reason == "BLOCKED";
        EXPECT_TRUE(line.reason != "SLOWED" || line.distance_m > 0);
        EXPECT_LT(line.command_ahead_mps, 2);  // 4 m of room are too few for that
    }
    EXPECT_GE(limited, 36u);
    EXPECT_LT(summary()["guard"]["commanded_m"], summary()["guard"]["wished_m"]);
}

TEST_F(RunGuard, ChangesNothingOfTheRun)
{
    ASSERT_EQ(run(drive_log()).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(results() + "/guard.csv"));
    ASSERT_EQ(run_into(results("guarded"), drive_log(), small).exit_code, 0);
    EXPECT_EQ(
        file_content(results() + "/trajectory.tum"),
        file_content(results("guarded") + "/trajectory.tum"));
}

TEST_F(RunGuard, AWishNeedsAGuardAndTwoNumbers)
{
    EXPECT_EQ(run(drive_log(), {"--wish", "1,0"}).exit_code, 2);
    const auto result = run(drive_log(), {"--guard", "--wish", "fast"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("--wish 0.5,0"));
}
}  // namespace
}  // namespace rtob::test

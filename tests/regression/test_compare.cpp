// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "near_pose.h"
#include "rtob_slam_run.h"

/// `rtob-slam compare` as a process: the variants run in processes of their own.
namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

constexpr int drive_scans = 40;

std::string field_of(const std::string& row, int column)
{
    std::istringstream fields(row);
    std::string field;
    for (int k = 0; k <= column; ++k) std::getline(fields, field, ',');
    return field;
}
double error_of(const std::string& row)
{
    return std::stod(field_of(row, 5));
}

class CompareVerb : public RunFixture
{
 protected:
    /// The fewest runs.
    [[nodiscard]] ProgramResult compare(
        const std::string& log, const std::vector<std::string>& more) const
    {
        std::vector<std::string> arguments{"compare",   log, "-o",      results(),
                                           "--repeats", "1", "--seeds", "1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(RTOB_PROGRAM, arguments);
    }
    [[nodiscard]] std::string result_file(const std::string& name) const
    {
        return file_content(results() + "/" + name);
    }
    /// The lines of results.csv after its header.
    [[nodiscard]] std::vector<std::string> rows() const
    {
        std::vector<std::string> rows;
        std::istringstream in(result_file("results.csv"));
        for (std::string line; std::getline(in, line);) rows.push_back(line);
        if (!rows.empty()) rows.erase(rows.begin());
        return rows;
    }
    /// The drive's own truth: each pose seen from five scans before.
    [[nodiscard]] std::string drive_relations() const
    {
        std::ostringstream text;
        text.precision(17);
        for (int k = 5; k < drive_scans; ++k)
        {
            const Pose2 motion = between(pose_on_circle(k - 5), pose_on_circle(k));
            text << drive_start_s + (k - 5) * drive_step_s << ' '
                 << drive_start_s + k * drive_step_s << ' ' << motion.x << ' ' << motion.y
                 << " 0 0 0 " << motion.yaw << '\n';
        }
        return folder_.write("drive.relations", text.str());
    }
    void expect_refused(const ProgramResult& result, const std::string& what) const
    {
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_THAT(result.err, HasSubstr(what));
        EXPECT_FALSE(std::filesystem::exists(results()));
    }
};

TEST_F(CompareVerb, JudgesEveryVariantByTheTruth)
{
    const auto result = compare(
        drive_log(), {"--truth", drive_relations(), "--variant", "rtob-revisit", "--variant",
                      "mrpt-dense", "--variant", "odometry"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("report.html"));
    ASSERT_THAT(rows(), SizeIs(3));
    for (const auto& row : rows())
    {
        EXPECT_EQ(field_of(row, 3), "40") << row;
        // The room's corners hold both within a few mm, and this odometry is exact.
        EXPECT_LT(error_of(row), 0.03) << row;
    }
    const auto html = result_file("report.html");
    for (const char* what :
         {"rtob-revisit", "mrpt-dense", "odometry", "Error over time", "data:image/png;base64,",
          "checked by hand"})
        EXPECT_THAT(html, HasSubstr(what));
}

TEST_F(CompareVerb, TakesATrajectoryInItsOwnMapAsTruth)
{
    std::vector<StampedPose2> truth;
    for (int k = 0; k < drive_scans; ++k)
        truth.push_back({drive_start_s + k * drive_step_s, pose_on_circle(k)});
    write_tum(folder_.file("truth.tum"), truth);
    const auto result =
        compare(drive_log(), {"--truth", folder_.file("truth.tum"), "--variant", "odometry"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    // The odometry is the truth seen from its first pose; files round to a micrometre.
    ASSERT_THAT(rows(), SizeIs(1));
    EXPECT_LT(error_of(rows()[0]), 1e-5);
    EXPECT_THAT(result_file("report.md"), HasSubstr("a shift and a turn"));
}

TEST_F(CompareVerb, RunsRtobAsTheVerbRunDoes)
{
    const auto log = drive_log();
    ASSERT_EQ(compare(log, {"--variant", "rtob-window", "--density", "window"}).exit_code, 0);
    ASSERT_EQ(run_into(results("run"), log, {"--density", "window"}).exit_code, 0);
    EXPECT_EQ(
        result_file("runs/rtob-window-1/trajectory.tum"),
        file_content(results("run") + "/trajectory.tum"));
}

TEST_F(CompareVerb, EveryVariantGivesAPoseForEachScanAtItsStamp)
{
    ASSERT_EQ(compare(drive_log(), {}).exit_code, 0);
    for (const char* run :
         {"rtob-revisit-1", "mrpt-stock-1", "mrpt-dense-1", "mrpt-lm-1", "mrpt-grid-1",
          "odometry-1"})
    {
        const auto path = read_tum(results() + "/runs/" + run + "/trajectory.tum");
        ASSERT_THAT(path, SizeIs(drive_scans)) << run;
        for (int k = 0; k < drive_scans; ++k)
            EXPECT_NEAR(
                path[static_cast<std::size_t>(k)].time_s, drive_start_s + k * drive_step_s, 1e-6)
                << run;
        // Odometry is exact here; the stock settings match coarsely, yet must follow.
        EXPECT_THAT(path.back().pose, IsNearPose(pose_on_circle_map(drive_scans - 1), 0.2, 0.2))
            << run;
    }
}

TEST_F(CompareVerb, AFailingVariantIsReportedAndStopsNoOther)
{
    const auto broken = folder_.write("broken.ini", "[MappingApplication]\n");
    const auto result = compare(
        drive_log(), {"--mrpt", broken, "--variant", "mrpt-broken", "--variant", "mrpt-stock"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("mrpt-broken failed: "));
    EXPECT_THAT(rows(), Contains(AllOf(StartsWith("mrpt-broken,1,,,"), HasSubstr(broken))));
    EXPECT_THAT(rows(), Contains(StartsWith("mrpt-stock,1,,40,")));
    EXPECT_THAT(result_file("report.html"), HasSubstr("failed: "));
    EXPECT_THAT(result_file("report.md"), HasSubstr("Failed: mrpt-broken"));
}

TEST_F(CompareVerb, FailsWhereEveryVariantFails)
{
    const auto result =
        compare(drive_log(), {"--mrpt", folder_.file("none.ini"), "--variant", "mrpt-none"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(rows(), Contains(HasSubstr("none.ini is missing")));
}

TEST_F(CompareVerb, WithoutOdometryOnlyOdometryFails)
{
    const auto result = compare(
        drive_log(), {"--no-odometry", "--variant", "odometry", "--variant", "rtob-revisit"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(
        rows(), Contains(AllOf(StartsWith("odometry,"), HasSubstr("the log has no odometry"))));
    EXPECT_THAT(rows(), Contains(StartsWith("rtob-revisit,1,1,40,")));
    EXPECT_THAT(result_file("report.md"), HasSubstr("The log has no odometry"));
}

TEST_F(CompareVerb, RefusesATruthThatIsNotThere)
{
    expect_refused(compare(drive_log(), {"--truth", folder_.file("no.relations")}), "no.relations");
}

TEST_F(CompareVerb, RefusesATruthOfAnotherTime)
{
    const auto truth = folder_.write("other.relations", "5 6 0.1 0 0 0 0 0\n");
    expect_refused(compare(drive_log(), {"--truth", truth}), truth);
}

TEST_F(CompareVerb, RefusesALogWithoutScans)
{
    expect_refused(
        compare(write_log("empty.rawlog", {odometry_on_circle(0)}), {}), "no 2D laser scan");
}

TEST_F(CompareVerb, RefusesAVariantThatDoesNotExist)
{
    const auto result = compare(drive_log(), {"--variant", "mrpt-stok"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("did you mean 'mrpt-stock'?"));
    EXPECT_FALSE(std::filesystem::exists(results()));
}

TEST_F(CompareVerb, RefusesTruthsThatAreNotOneForEachLog)
{
    const auto result = compare(drive_log(), {"--truth", "a", "--truth", "b"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("1 logs and 2 truths"));
}

TEST_F(CompareVerb, RunsOfAnEarlierComparisonGo)
{
    const auto log = drive_log();
    ASSERT_EQ(compare(log, {"--variant", "mrpt-stock"}).exit_code, 0);
    ASSERT_EQ(compare(log, {"--variant", "odometry"}).exit_code, 1);  // the folder is not empty
    ASSERT_EQ(compare(log, {"--variant", "odometry", "--overwrite"}).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(results() + "/runs/mrpt-stock-1"));
    EXPECT_TRUE(std::filesystem::exists(results() + "/runs/odometry-1"));
}

TEST_F(CompareVerb, TheVerbOfASingleRunIsInNoHelp)
{
    const auto help = run_program(RTOB_PROGRAM, {"--help"});
    EXPECT_THAT(help.out, HasSubstr("compare"));
    EXPECT_THAT(help.out, Not(HasSubstr("compare-run")));
}
}  // namespace
}  // namespace rtob::test

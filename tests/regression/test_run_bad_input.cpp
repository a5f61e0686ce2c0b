// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "carmen_text.h"
#include "near_pose.h"
#include "rtob_slam_run.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

class BadInput : public RunFixture
{
 protected:
    /// Refused with these words, nothing written.
    void expect_refused(
        const ProgramResult& result, const std::string& place, const std::string& problem) const
    {
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_THAT(result.err, AllOf(HasSubstr(place), HasSubstr(problem)));
        EXPECT_EQ(result.out, "");
        EXPECT_FALSE(std::filesystem::exists(results()));
    }
    void expect_ini_refused(
        const std::string& ini, const std::string& place, const std::string& problem) const
    {
        const auto file = folder_.write("bad.ini", ini);
        const auto result = run(drive_log(), {"-c", file});
        EXPECT_THAT(result.err, HasSubstr(file));
        expect_refused(result, place, problem);
    }
    /// The drive with these in place of its scans 10 to 14: the run must get over them.
    void expect_survives(
        const std::function<LogObjects::value_type(double stamp_s)>& bad_scan) const
    {
        auto objects = drive_objects(40);
        for (int k = 10; k < 15; ++k)
            objects[static_cast<std::size_t>(2 * k + 1)] =
                bad_scan(drive_start_s + k * drive_step_s);
        const auto result = run(write_log("drive.rawlog", objects));
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const auto poses = trajectory();
        ASSERT_EQ(poses.size(), 40u) << "a line for every scan, also for bad ones";
        for (std::size_t k = 0; k < 40; ++k)
            EXPECT_NEAR(poses[k].time_s, drive_start_s + double(k) * drive_step_s, 1e-6);
        EXPECT_THAT(poses.back().pose, IsNearPose(pose_on_circle_map(39), 0.02, 0.01));
        // Five in a row lose the vehicle; while it makes sure where it is, good ones count, too.
        const auto rejected = summary()["scans"]["rejected"].get<int>();
        EXPECT_GE(rejected, 5);
        EXPECT_LE(rejected, 5 + 3) << "Relocalise.confirm_scans";
        EXPECT_EQ(summary()["states"]["final"], "TRACKING");
    }
};

TEST_F(BadInput, MissingLog)
{
    expect_refused(run(folder_.file("none.rawlog")), folder_.file("none.rawlog"), "No such file");
}

TEST_F(BadInput, EmptyLog)
{
    const auto log = folder_.write("empty.rawlog", "");
    expect_refused(run(log), log, "empty");
}

TEST_F(BadInput, NeitherRawlogNorText)
{
    const auto log = folder_.write("picture.rawlog", std::string("\x89PNG\r\n\x1a\n\0\0\0\r", 12));
    expect_refused(run(log), log, "neither an MRPT rawlog nor a CARMEN");
}

TEST_F(BadInput, FolderInPlaceOfALog)
{
    expect_refused(run(folder_.path()), folder_.path(), "folder");
}

TEST_F(BadInput, ATruncatedLogGivesWhatComesBefore)
{
    for (const bool packed : {true, false})
    {
        auto bytes = rawlog_bytes(drive_objects(40));
        if (packed) bytes = gzip(bytes);
        const auto log = folder_.write("cut.rawlog", bytes.substr(0, bytes.size() / 2 + 7));
        const auto result = run(log, {"--overwrite"});
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_THAT(
            result.err,
            AllOf(HasSubstr(log + ", entry "), HasSubstr("cut"), HasSubstr("is in " + results())));
        const auto poses = trajectory();
        EXPECT_GT(poses.size(), 10u);
        EXPECT_LT(poses.size(), 40u);
        EXPECT_THAT(summary()["ended"].get<std::string>(), HasSubstr("damaged"));
        EXPECT_TRUE(std::filesystem::exists(results() + "/map.png"));
    }
}

TEST_F(BadInput, ADamagedLineGivesWhatComesBefore)
{
    const auto log = folder_.write("bad.log", flaser_of(180) + flaser_of(180) + "FLASER 180 1.0\n");
    const auto result = run(log);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(log + ", line 3"));
    EXPECT_EQ(trajectory().size(), 2u);
}

TEST_F(BadInput, ALogCutBeforeItsFirstScanLeavesNothing)
{
    const auto bytes = rawlog_bytes({scan_on_circle(0)});
    const auto log = folder_.write("cut.rawlog", bytes.substr(0, bytes.size() / 2));
    expect_refused(run(log), log + ", entry 1", "truncated");
}

TEST_F(BadInput, ALogWithoutScans)
{
    const auto log = write_log("odometry.rawlog", {odometry_on_circle(0), odometry_on_circle(1)});
    expect_refused(run(log), log, "no 2D laser scan (2 other observations)");
}

TEST_F(BadInput, ALogWithoutScansOfTheChosenLaser)
{
    const auto log = drive_log();
    expect_refused(run(log, {"--set", "Sensor.labels=REAR"}), log, "The log's lasers: 'LASER'");
}

TEST_F(BadInput, SkippingAllScans)
{
    const auto log = drive_log();
    expect_refused(run(log, {"--skip", "40"}), log, "only 40 scans");
}

TEST_F(BadInput, ScansWithoutBeams)
{
    expect_survives([](double stamp_s) { return scan_of(0, 0, false, stamp_s); });
}
TEST_F(BadInput, ScansWithOneBeam)
{
    expect_survives([](double stamp_s) { return scan_of(1, 2, true, stamp_s); });
}
TEST_F(BadInput, ScansWithInvalidBeamsOnly)
{
    expect_survives([](double stamp_s) { return scan_of(361, 2, false, stamp_s); });
}
TEST_F(BadInput, RangesThatAreNoNumbers)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    expect_survives([nan](double stamp_s) { return scan_of(361, nan, true, stamp_s); });
    EXPECT_EQ(summary()["beams"]["not_a_number"], 5 * 361);
}
TEST_F(BadInput, NegativeRanges)
{
    expect_survives([](double stamp_s) { return scan_of(361, -1, true, stamp_s); });
    EXPECT_EQ(summary()["beams"]["not_positive"], 5 * 361);
}

TEST_F(BadInput, ALogOfUselessScansIsNoSuccess)
{
    LogObjects objects;
    for (int k = 0; k < 5; ++k) objects.push_back(scan_of(181, 80, true, k));
    const auto result = run(write_log("far.rawlog", objects));
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(
        result.err, AllOf(HasSubstr("none of the 5 scans"), HasSubstr(results() + "/summary.txt")));
    EXPECT_EQ(summary()["beams"]["too_far"], 5 * 181);
    EXPECT_EQ(trajectory().size(), 5u);
}

TEST_F(BadInput, AFirstScanOfOneBeamStartsNoMap)
{
    auto objects = drive_objects(40);
    objects.insert(objects.begin(), scan_of(1, 2, true, drive_start_s - drive_step_s));
    EXPECT_EQ(run(write_log("drive.rawlog", objects)).exit_code, 0);
    EXPECT_THAT(trajectory().back().pose, IsNearPose(pose_on_circle_map(39), 0.02, 0.01));
}

TEST_F(BadInput, StampsThatRepeatStepBackAndJump)
{
    auto objects = drive_objects(40);
    const auto stamp = [&](std::size_t scan, double stamp_s)
    {
        const auto object =
            std::dynamic_pointer_cast<mrpt::obs::CObservation>(objects[2 * scan + 1]);
        object->timestamp = mrpt::Clock::fromDouble(stamp_s);
    };
    constexpr double day_s = 86400;
    stamp(10, drive_start_s + 0.9);  // as scan 9: repeats
    stamp(20, drive_start_s + 1.5);  // before scan 19: steps back
    for (std::size_t k = 30; k < 40; ++k) stamp(k, day_s + double(k));  // one jump
    const auto result = run(write_log("stamps.rawlog", objects));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto poses = trajectory();
    ASSERT_EQ(poses.size(), 40u);
    EXPECT_NEAR(poses[20].time_s, drive_start_s + 1.5, 1e-6) << "the log's own stamp and order";
    EXPECT_NEAR(poses[30].time_s, day_s + 30, 1e-6);
    EXPECT_THAT(poses.back().pose, IsNearPose(pose_on_circle_map(39), 0.02, 0.01));
    EXPECT_EQ(summary()["stamps"]["repeats"], 1);
    EXPECT_EQ(summary()["stamps"]["steps_back"], 1);
    EXPECT_EQ(summary()["stamps"]["jumps"], 1);
    EXPECT_EQ(summary()["states"]["TRACKING"], 40);
}

TEST_F(BadInput, AScanWithoutAStampIsCounted)
{
    auto objects = drive_objects(10);
    std::dynamic_pointer_cast<mrpt::obs::CObservation>(objects[9])->timestamp = INVALID_TIMESTAMP;
    EXPECT_EQ(run(write_log("drive.rawlog", objects)).exit_code, 0);
    EXPECT_EQ(summary()["stamps"]["invalid"], 1);
    ASSERT_EQ(trajectory().size(), 10u) << "still a file that can be read";
    EXPECT_EQ(trajectory()[4].time_s, 0);
}

TEST_F(BadInput, MissingIni)
{
    expect_refused(
        run(drive_log(), {"-c", folder_.file("none.ini")}), folder_.file("none.ini"),
        "does not exist");
}
TEST_F(BadInput, IniWithAWrongType)
{
    expect_ini_refused("[Draw]\npoints = many\n", "[Draw]", "key points: 'many' is not");
}
TEST_F(BadInput, IniWithAValueOutOfRange)
{
    expect_ini_refused("[ScanFilter]\nmin_range_m = -1\n", "[ScanFilter]", "min_range_m");
}
TEST_F(BadInput, IniWithAnUnknownKey)
{
    expect_ini_refused("[Draw]\npointz = 100\n", "[Draw]", "did you mean 'points'?");
}
TEST_F(BadInput, IniWithAnUnknownSection)
{
    expect_ini_refused("[Drow]\npoints = 100\n", "[Drow]", "did you mean 'Draw'?");
}
TEST_F(BadInput, IniWithALineThatIsNothing)
{
    expect_ini_refused("[Draw]\npoints\n", "line 2", "'points' is neither");
}
}  // namespace
}  // namespace rtob::test

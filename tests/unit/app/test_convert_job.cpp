// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include "carmen_text.h"
#include "convert/convert_job.h"
#include "drive_log.h"
#include "error_message.h"
#include "same_scan.h"
#include "temporary_folder.h"
#include "usage_error.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

bool never()
{
    return false;
}

class ConvertLog : public testing::Test
{
 protected:
    ConvertJob job(const std::string& log, const std::string& output) const
    {
        ConvertJob made;
        made.log = log;
        made.output = folder_.file(output);
        made.target = convert_target(output, "");
        return made;
    }
    std::string rawlog(const LogObjects& objects, const std::string& name = "in.rawlog") const
    {
        return folder_.write(name, rawlog_bytes(objects));
    }
    template <class Error = std::runtime_error>
    std::string refusal(const ConvertJob& refused) const
    {
        return error_message<Error>([&] { static_cast<void>(convert_log(refused, never)); });
    }
    /// 400 FLASER lines of 180 beams of 2.5 m; each has one beam of 81.83 m, a different one.
    std::string sick_log() const
    {
        std::string text;
        for (std::size_t k = 0; k < 400; ++k)
        {
            std::vector<std::string> ranges(180, "2.5");
            ranges[k % 180] = "81.83";
            text += flaser("180 " + joined(ranges), "1 0 0", "1 0 0", std::to_string(10 + k));
        }
        return folder_.write("sick.log", text);
    }

    TemporaryFolder folder_;
};

mrpt::obs::CObservationRobotPose::Ptr robot_pose()
{
    auto pose = mrpt::obs::CObservationRobotPose::Create();
    pose->timestamp = mrpt::Clock::fromDouble(1000);
    pose->sensorLabel = "truth";
    pose->pose.mean.x(7);
    return pose;
}

TEST_F(ConvertLog, MarksNoReturnsThatTheLogDoesNotTell)
{
    const auto to = job(sick_log(), "sick.rawlog");
    const auto conversion = convert_log(to, never);
    EXPECT_THAT(
        conversion_text(to, conversion),
        AllOf(
            HasSubstr("400 scans, 400 odometry readings\n"),
            HasSubstr("laser_front: 81.83 m and more means no return (400 beams)")));
    const auto scan = read_log(to.output).scans().at(3);
    EXPECT_FLOAT_EQ(scan->maxRange, 81.83F);
    EXPECT_FALSE(scan->getScanRangeValidity(3));
    EXPECT_FLOAT_EQ(scan->getScanRange(3), 81.83F);
    EXPECT_TRUE(scan->getScanRangeValidity(4));
}

TEST_F(ConvertLog, TakesTheMaximumRangeThatIsAskedFor)
{
    auto to = job(sick_log(), "sick.rawlog");
    to.choice.max_range_m = 2;
    static_cast<void>(convert_log(to, never));
    const auto scan = read_log(to.output).scans().at(0);
    EXPECT_FLOAT_EQ(scan->maxRange, 2);
    EXPECT_FALSE(scan->getScanRangeValidity(4));
}

TEST_F(ConvertLog, TakesTheChosenLasersAndPosesOnly)
{
    auto other = scan_on_circle(1);
    other->sensorLabel = "REAR";
    auto to =
        job(rawlog({odometry_on_circle(0), robot_pose(), scan_on_circle(0), other}), "b.rawlog");
    to.choice.lasers = {"LASER"};
    to.choice.poses = {"truth"};
    const auto conversion = convert_log(to, never);
    EXPECT_EQ(conversion.scans, 1U);
    EXPECT_EQ(conversion.robot_poses, 1U);
    EXPECT_THAT(
        conversion.losses,
        ElementsAre(Pair(HasSubstr("poses of sensor ''"), 1), Pair(HasSubstr("laser 'REAR'"), 1)));
}

TEST_F(ConvertLog, PrefersRobotPosesToOdometry)
{
    const auto log = rawlog({odometry_on_circle(0), robot_pose()});
    static_cast<void>(convert_log(job(log, "a.tum"), never));
    EXPECT_THAT(file_content(folder_.file("a.tum")), HasSubstr("1000.000000 7.000000 0.000000"));
    auto odometry = job(log, "b.tum");
    odometry.poses_are_odometry = true;
    static_cast<void>(convert_log(odometry, never));
    EXPECT_THAT(file_content(folder_.file("b.tum")), HasSubstr("\n1000.240000 2.000000 1.200000"));
}

TEST_F(ConvertLog, TurnsTumPosesIntoEither)
{
    const auto tum = folder_.write("a.tum", "5 1 2 0 0 0 0 1\n");
    static_cast<void>(convert_log(job(tum, "pose.rawlog"), never));
    EXPECT_EQ(
        read_log(folder_.file("pose.rawlog")).all<mrpt::obs::CObservationRobotPose>().size(), 1U);
    auto odometry = job(tum, "odometry.rawlog");
    odometry.poses_are_odometry = true;
    static_cast<void>(convert_log(odometry, never));
    EXPECT_EQ(read_log(odometry.output).odometry().at(0)->odometry.y(), 2);
}

TEST_F(ConvertLog, RefusesWhatMakesNoSense)
{
    const auto tum = folder_.write("a.tum", "5 1 2 0 0 0 0 1\n");
    const auto log = rawlog(drive_objects(2));
    EXPECT_THAT(refusal<UsageError>(job(tum, "a.log")), HasSubstr("poses only"));
    EXPECT_THAT(refusal<UsageError>(job(log, "in.rawlog")), HasSubstr("same file"));
    auto odometry = job(log, "b.rawlog");
    odometry.poses_are_odometry = true;
    EXPECT_THAT(refusal<UsageError>(odometry), HasSubstr("--odometry"));
    EXPECT_THAT(refusal(job("/nowhere/a.log", "b.rawlog")), HasSubstr("/nowhere/a.log"));
    auto nowhere = job(log, "b.rawlog");
    nowhere.output = "/nowhere/b.rawlog";
    EXPECT_THAT(refusal(nowhere), HasSubstr("/nowhere/b.rawlog: cannot be written"));
    nowhere.output = folder_.path();
    EXPECT_THAT(refusal(nowhere), HasSubstr("folder"));
}

TEST_F(ConvertLog, RefusesLabelsAndLogsThatHoldNothing)
{
    auto to = job(rawlog(drive_objects(2)), "b.rawlog");
    to.choice.lasers = {"LASER", "LESAR"};
    EXPECT_THAT(refusal(to), AllOf(HasSubstr("no laser 'LESAR'"), HasSubstr("rawlog-edit")));
    to.choice = {};
    to.choice.poses = {"gps"};
    EXPECT_THAT(refusal(to), HasSubstr("no odometry or robot poses 'gps'"));
    EXPECT_THAT(
        refusal(job(folder_.write("empty.log", "# nothing\n"), "c.rawlog")),
        HasSubstr("holds no scan"));
}

TEST_F(ConvertLog, ReplacesAFileOnlyWhenAsked)
{
    auto to = job(rawlog(drive_objects(2)), "b.log");
    folder_.write("b.log", "precious");
    EXPECT_THAT(refusal(to), AllOf(HasSubstr("b.log exists"), HasSubstr("--overwrite")));
    EXPECT_EQ(file_content(to.output), "precious");
    to.may_overwrite = true;
    static_cast<void>(convert_log(to, never));
    EXPECT_EQ(read_log(to.output).scans().size(), 2U);
}

TEST_F(ConvertLog, OfADamagedLogKeepsAPartOnlyWhenAsked)
{
    const std::string bytes = rawlog_bytes(drive_objects(3));
    auto to = job(folder_.write("in.rawlog", bytes.substr(0, bytes.size() - 10)), "b.log");
    EXPECT_THAT(refusal(to), AllOf(HasSubstr("entry 6"), HasSubstr("--keep-part")));
    EXPECT_FALSE(std::filesystem::exists(to.output));
    to.keep_part = true;
    const auto conversion = convert_log(to, never);
    EXPECT_THAT(conversion.damage, HasSubstr("entry 6"));
    EXPECT_EQ(read_log(to.output).scans().size(), 2U);
}

TEST_F(ConvertLog, StoppedLeavesNothing)
{
    const auto to = job(rawlog(drive_objects(3)), "b.log");
    int calls = 0;
    const auto in_the_second_pass = [&] { return ++calls > 8; };
    EXPECT_THAT(
        error_message([&] { static_cast<void>(convert_log(to, in_the_second_pass)); }),
        HasSubstr("signal"));
    for (const auto& file : std::filesystem::directory_iterator(folder_.path()))
        EXPECT_EQ(file.path().filename(), "in.rawlog");
}
}  // namespace
}  // namespace rtob::test

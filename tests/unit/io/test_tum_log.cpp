// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <rtob/io/tum_log.h>

#include "drive_log.h"
#include "error_message.h"
#include "log_files.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
using mrpt::obs::CObservationRobotPose;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

// Half a turn about z, then a pose with every number set.
const std::string poses_text =
    "# a comment\n"
    "1000.25 1 2 0 0 0 1 0\n"
    "\n"
    "1000.3500001 -1 2.5 0.125 0.5 -0.5 0.5 0.5\n";

class TumLog : public testing::Test
{
 protected:
    std::string written(LogReader& survey, LogReader& log, PoseMeaning meaning)
    {
        const std::string file = folder_.file("out.tum");
        TumLogWriter writer(file, survey_log(survey), meaning);
        while (const auto entry = log.next()) writer.write(*entry);
        writer.commit();
        losses_ = writer.losses();
        return file_content(file);
    }
    std::string written(const LogObjects& objects, PoseMeaning meaning)
    {
        const auto log = folder_.write("log.rawlog", rawlog_bytes(objects));
        return written(*open_log(log), *open_log(log), meaning);
    }

    TemporaryFolder folder_;
    LogLosses losses_;
};

TEST_F(TumLog, GivesRobotPosesInSpace)
{
    const auto log = open_tum_log(folder_.write("a.tum", poses_text), PoseMeaning::RobotPose);
    const auto first = log->next(), second = log->next();
    ASSERT_TRUE(first && second && !log->next());
    const auto& pose = dynamic_cast<const CObservationRobotPose&>(*second->observation);
    EXPECT_EQ(pose.sensorLabel, "pose");
    EXPECT_EQ(unix_100ns(pose), 10'003'500'001);
    EXPECT_DOUBLE_EQ(pose.pose.mean.z(), 0.125);
    EXPECT_EQ(unix_100ns(*first->observation), 10'002'500'000);
}

TEST_F(TumLog, WritesWhatItRead)
{
    const auto file = folder_.write("a.tum", poses_text);
    const auto text = written(
        *open_tum_log(file, PoseMeaning::RobotPose), *open_tum_log(file, PoseMeaning::RobotPose),
        PoseMeaning::RobotPose);
    EXPECT_THAT(
        text,
        testing::AllOf(
            HasSubstr("1000.250000 1.000000 2.000000 0.000000 0.000000000 0.000000000 1.000000000"),
            HasSubstr("1000.3500001 -1.000000 2.500000 0.125000 0.500000000 -0.500000000 "
                      "0.500000000 0.500000000")));
}

TEST_F(TumLog, OdometryLiesInThePlaneAndSaysWhatItLost)
{
    const auto log = open_tum_log(folder_.write("a.tum", poses_text), PoseMeaning::Odometry);
    const auto first = log->next();
    const auto& odometry =
        dynamic_cast<const mrpt::obs::CObservationOdometry&>(*first->observation).odometry;
    EXPECT_DOUBLE_EQ(odometry.x(), 1);
    EXPECT_NEAR(std::abs(odometry.phi()), 3.14159265358979323846, 1e-12);
    EXPECT_THAT(log->losses(), IsEmpty());
    static_cast<void>(log->next());
    EXPECT_THAT(
        log->losses(), ElementsAre(Pair(HasSubstr("heights"), 1), Pair(HasSubstr("pitch"), 1)));
}

TEST_F(TumLog, WritesOdometryAndCountsTheRest)
{
    const auto text = written({odometry_on_circle(0), scan_on_circle(0)}, PoseMeaning::Odometry);
    EXPECT_THAT(text, HasSubstr("\n1000.240000 2.000000 1.200000 0.000000 0.000000000 "));
    EXPECT_THAT(losses_, ElementsAre(Pair(HasSubstr("CObservation2DRangeScan"), 1)));
}

TEST_F(TumLog, TellsThatCovariancesAreLost)
{
    auto pose = CObservationRobotPose::Create();
    pose->timestamp = mrpt::Clock::fromDouble(1);
    pose->pose.cov(0, 0) = 0.01;
    static_cast<void>(written({pose}, PoseMeaning::RobotPose));
    EXPECT_THAT(losses_, ElementsAre(Pair(HasSubstr("covariances"), 1)));
}

TEST_F(TumLog, RefusesLogsWithoutPosesOrWithTooMany)
{
    const auto refusal = [&](const LogObjects& objects, PoseMeaning meaning)
    { return error_message([&] { static_cast<void>(written(objects, meaning)); }); };
    EXPECT_THAT(refusal({scan_on_circle(0)}, PoseMeaning::Odometry), HasSubstr("`rtob-slam run`"));
    auto other = odometry_on_circle(1);
    other->sensorLabel = "visual";
    EXPECT_THAT(
        refusal({odometry_on_circle(0), other}, PoseMeaning::Odometry),
        testing::AllOf(HasSubstr("'visual'"), HasSubstr("--poses")));
}

TEST_F(TumLog, IsKnownByItsFirstNumber)
{
    const auto is_tum = [&](const std::string& text)
    { return is_tum_file(folder_.write("a", text)); };
    EXPECT_TRUE(is_tum(poses_text));
    EXPECT_TRUE(is_tum(gzip(poses_text)));
    EXPECT_FALSE(is_tum("# only a comment\n"));
    EXPECT_FALSE(is_tum("FLASER 1 2\n"));
    EXPECT_FALSE(is_tum(rawlog_bytes({scan_on_circle(0)})));
    EXPECT_THAT(
        error_message([] { static_cast<void>(is_tum_file("/nowhere/a.tum")); }),
        HasSubstr("/nowhere/a.tum: cannot be opened"));
}

TEST_F(TumLog, NamesABadLine)
{
    const auto log =
        open_tum_log(folder_.write("a.tum", poses_text + "5 x\n"), PoseMeaning::RobotPose);
    EXPECT_THAT(
        error_message(
            [&]
            {
                while (log->next()) continue;
            }),
        testing::AllOf(HasSubstr("line 5"), HasSubstr("'x'")));
}
}  // namespace
}  // namespace rtob::test

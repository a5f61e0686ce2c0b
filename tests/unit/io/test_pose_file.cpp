// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <rtob/io/pose_file.h>

#include "error_message.h"
#include "log_files.h"
#include "near_pose.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
using mrpt::obs::CObservationRobotPose;
using testing::AllOf;
using testing::HasSubstr;

PoseFileKind kind_of(const std::string& text)
{
    const TemporaryFile file("_kind", text);
    return pose_file_kind(file.path());
}

std::string kind_error(const std::string& text)
{
    const TemporaryFile file("_bad", text);
    return error_message<LogError>([&] { static_cast<void>(pose_file_kind(file.path())); });
}

std::string read_error(const std::string& file)
{
    return error_message<LogError>([&] { static_cast<void>(read_poses(file)); });
}

CObservationRobotPose::Ptr robot_pose(double time_s, const Pose2& pose_map_vehicle)
{
    auto observation = CObservationRobotPose::Create();
    observation->timestamp = mrpt::Clock::fromDouble(time_s);
    observation->sensorLabel = "truth";
    observation->pose.mean = mrpt::poses::CPose3D(
        pose_map_vehicle.x, pose_map_vehicle.y, 0.3, pose_map_vehicle.yaw, 0, 0);
    return observation;
}

TEST(PoseFileKind, IsToldByTheContent)
{
    EXPECT_EQ(kind_of("1.5 2 3 0 0 0 0.6 0.8\n"), PoseFileKind::Tum);
    EXPECT_EQ(kind_of("# a comment\n\n 1\t2 3 0.5\n"), PoseFileKind::Planar);
    EXPECT_EQ(kind_of("1 2 3 0 0 0 0 0.25\r\n"), PoseFileKind::Relations);
}

TEST(PoseFileKind, TellsTumFromRelations)
{
    const std::string either = "1 2 0.5 0 0 0 0 1\n";  // no turn; or 1 rad from t = 1 to t = 2
    EXPECT_EQ(kind_of("1 2 0.5 0 0 0 0 0.25\n"), PoseFileKind::Relations);
    EXPECT_EQ(kind_of("1 2 0.5 0 0 0 0 0\n"), PoseFileKind::Relations);
    EXPECT_EQ(kind_of(either + "3 4 0.5 0 0 0 0 -0.1\n"), PoseFileKind::Relations);
    EXPECT_EQ(kind_of(either + "2 0.7 0 0 0 0 0.6 0.8\n"), PoseFileKind::Tum);
    EXPECT_EQ(kind_of("1 0 0 0 nan nan nan nan\n" + either), PoseFileKind::Tum)
        << "a vehicle that never turns";
}

TEST(PoseFileKind, SeesThroughCompression)
{
    EXPECT_EQ(kind_of(gzip("1 2 3 0.5\n")), PoseFileKind::Planar);
    EXPECT_EQ(kind_of(bzip2("1 2 0.5 0 0 0 0 0.25\n")), PoseFileKind::Relations);
    EXPECT_EQ(kind_of(rawlog_bytes({robot_pose(1, {})})), PoseFileKind::Rawlog);
}

TEST(PoseFileKind, RefusesOtherFiles)
{
    EXPECT_THAT(
        error_message<LogError>([] { static_cast<void>(pose_file_kind("/nowhere")); }),
        HasSubstr("/nowhere"));
    EXPECT_THAT(kind_error(""), HasSubstr("empty"));
    EXPECT_THAT(kind_error("# nothing\n\n"), HasSubstr("the file holds no poses"));
    EXPECT_THAT(
        kind_error("# log\nFLASER 2 1 1 0 0 0 0 0 0 1 h 1\n"),
        AllOf(HasSubstr("line 2"), HasSubstr("'FLASER'"), HasSubstr("Name a TUM file")));
    EXPECT_THAT(
        kind_error("1 0 0 0 0 1 0 0 0 0 1 0\n"),
        AllOf(HasSubstr("line 1: a line of 12 numbers"), HasSubstr("relations")));
    EXPECT_THAT(kind_error("1 2 3 4 0.5 0 0 0.1\n"), HasSubstr("neither TUM (a unit quaternion"));
    EXPECT_THAT(kind_error({"\x01\x02\x00\x03", 4}), HasSubstr("neither text nor MRPT"));
}

TEST(ReadPoses, ReadsPlanarLines)
{
    const TemporaryFile file(".GT.txt", "# time x y yaw\n1.25 2 -3 4\n1.5 0 0 -1\r\n");
    const auto poses = read_poses(file.path());
    ASSERT_EQ(poses.size(), 2u);
    EXPECT_EQ(poses[0].time_s, 1.25);
    EXPECT_THAT(poses[0].pose, IsNearPose(Pose2{2, -3, wrap_angle(4)}, 0, 1e-15));
    EXPECT_THAT(poses[1].pose, IsNearPose(Pose2{0, 0, -1}, 0, 0));
}

TEST(ReadPoses, ReadsTum)
{
    const TemporaryFile file(".tum", "1 2 3 0 0 0 0 1\n2 3 3 0 0 0 0.6 0.8\n");
    EXPECT_EQ(read_poses(file.path()).size(), 2u);
}

TEST(ReadPoses, TakesTheObservedPosesOfARawlog)
{
    const TemporaryFile file(
        ".rawlog", rawlog_bytes(
                       {robot_pose(10.5, {1, 2, 0.5}), mrpt::obs::CObservationOdometry::Create(),
                        robot_pose(10.25, {-1, 0, -3})}));
    const auto poses = read_poses(file.path());
    ASSERT_EQ(poses.size(), 2u);
    EXPECT_NEAR(poses[0].time_s, 10.5, 1e-7);  // MRPT counts in units of 100 ns
    EXPECT_NEAR(poses[1].time_s, 10.25, 1e-7);
    EXPECT_THAT(poses[0].pose, IsNearPose(Pose2{1, 2, 0.5}, 1e-12, 1e-12));
    EXPECT_THAT(poses[1].pose, IsNearPose(Pose2{-1, 0, -3}, 1e-12, 1e-12));
}

TEST(ReadPoses, TakesTheTruthBesideARawlogWithoutPoses)
{
    const TemporaryFolder folder;
    const auto rawlog =
        folder.write("a.rawlog", rawlog_bytes({mrpt::obs::CObservationOdometry::Create()}));
    EXPECT_THAT(
        read_error(rawlog),
        AllOf(HasSubstr(rawlog + ": the rawlog holds no poses"), HasSubstr(".rawlog.GT.txt")));
    folder.write("a.rawlog.GT.txt", "5 1 2 0\n");
    EXPECT_EQ(read_poses(rawlog).at(0).pose.y, 2);
}

TEST(ReadPoses, NamesTheLineThatIsWrong)
{
    const TemporaryFile planar("_planar", "1 2 3 0\n2 2 nan 0\n");
    EXPECT_THAT(
        read_error(planar.path()), AllOf(HasSubstr("line 2"), HasSubstr("y is not a finite")));
    const TemporaryFile longer("_longer", "1 2 3 0\n2 2 3 0 0\n");
    EXPECT_THAT(read_error(longer.path()), AllOf(HasSubstr("line 2"), HasSubstr("four numbers")));
    const TemporaryFile relations("_relations", "1 2 3 0 0 0 0 0.25\n");
    EXPECT_THAT(read_error(relations.path()), HasSubstr("relations stand where poses are needed"));
}

TEST(ReadPoses, RefusesPosesItCannotChooseFromOrPlaceInTime)
{
    auto other = robot_pose(2, {});
    other->sensorLabel = "gps";
    const TemporaryFile two("_two", rawlog_bytes({robot_pose(1, {}), other}));
    EXPECT_THAT(
        read_error(two.path()),
        AllOf(HasSubstr("pose 2"), HasSubstr("two sensors, 'truth' and 'gps'")));
    auto timeless = robot_pose(2, {});
    timeless->timestamp = INVALID_TIMESTAMP;
    const TemporaryFile no_time("_no_time", rawlog_bytes({timeless}));
    EXPECT_THAT(read_error(no_time.path()), HasSubstr("pose 1: it has no time"));
}

TEST(ReadPoses, ReadsTheTruthOfMrptsOwnLog)
{
    const std::string log =
        "/usr/share/mrpt/datasets/graphslam-engine-demos/action_observations_map/simul.rawlog";
    if (!std::filesystem::exists(log)) GTEST_SKIP() << "Debian's mrpt-common is not installed";
    const auto poses = read_poses(log);
    ASSERT_EQ(poses.size(), 1734u);  // the lines of simul.rawlog.GT.txt
    EXPECT_NEAR(poses.back().time_s, 1464600553.136479, 1e-6);
    EXPECT_THAT(poses.back().pose, IsNearPose(Pose2{-9.498, -18.341, -2.522}, 1e-12, 1e-12));
}
}  // namespace
}  // namespace rtob::test

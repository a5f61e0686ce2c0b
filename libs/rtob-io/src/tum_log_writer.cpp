// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/poses/CPose3DQuat.h>
#include <rtob/io/tum_log.h>

#include <stdexcept>

#include "motion_pose.h"
#include "mrpt_clock.h"
#include "number_text.h"
#include "tum_line.h"

namespace rtob
{
namespace
{
using namespace mrpt::obs;

PoseMeaning checked(const LogContents& contents, PoseMeaning meaning)
{
    const bool wants_odometry = meaning == PoseMeaning::Odometry;
    const auto& sensors = wants_odometry ? contents.odometry : contents.robot_poses;
    const std::size_t sources = sensors.size() + (wants_odometry && contents.motions > 0 ? 1 : 0);
    if (sources == 0)
        throw std::runtime_error(
            "a TUM file holds poses, and this log has neither robot poses nor odometry. `rtob-slam "
            "run` computes poses from its scans.");
    if (sources == 1) return meaning;
    std::string labels;
    for (const auto& [label, count] : sensors)
        labels += (labels.empty() ? "'" : ", '") + label + "'";
    throw std::runtime_error(
        "a TUM file holds the poses of one sensor, and this log has those of " +
        std::to_string(sources) + " (" + labels + "). Choose one with --poses LABEL.");
}
}  // namespace

TumLogWriter::TumLogWriter(
    const std::string& file, const LogContents& contents, PoseMeaning meaning)
    : meaning_(checked(contents, meaning)), out_(file)
{
    out_.stream() << "# time_s x_m y_m z_m qx qy qz qw\n";
}

void TumLogWriter::write(const LogEntry& entry)
{
    if (entry.motion)
    {
        pose_odom_vehicle_ = compose(pose_odom_vehicle_, pose2_of(*entry.motion));
        moved_ = true;
    }
    else
        writeObservation(*entry.observation);
    out_.check();
}

void TumLogWriter::writeObservation(const CObservation& observation)
{
    const auto* pose = dynamic_cast<const CObservationRobotPose*>(&observation);
    const auto* odometry = dynamic_cast<const CObservationOdometry*>(&observation);
    if (meaning_ == PoseMeaning::RobotPose && pose != nullptr)
    {
        if (pose->pose.cov.sum_abs() > 0) lose("covariances of poses");
        writePose(observation, pose->pose.mean);
    }
    else if (meaning_ == PoseMeaning::Odometry && odometry != nullptr)
        writePose(observation, mrpt::poses::CPose3D(odometry->odometry));
    else
        lose(std::string("observations of class ") + observation.GetRuntimeClass()->className);
    if (meaning_ == PoseMeaning::RobotPose || !moved_) return;
    const auto& now = pose_odom_vehicle_;
    writePose(observation, mrpt::poses::CPose3D(now.x, now.y, 0, now.yaw, 0, 0));
    moved_ = false;
}

void TumLogWriter::writePose(const CObservation& observation, const mrpt::poses::CPose3D& pose)
{
    if (observation.timestamp == INVALID_TIMESTAMP)
    {
        lose("poses without a stamp");
        return;
    }
    const mrpt::poses::CPose3DQuat q(pose);
    auto& out = out_.stream();
    write_ticks_100ns(out, unix_100ns_of(observation.timestamp));
    for (const double coordinate : {q.x(), q.y(), q.z()})
        write_fixed(out << ' ', coordinate, tum_position_decimals);
    for (const double turn : {q.quat().x(), q.quat().y(), q.quat().z(), q.quat().r()})
        write_fixed(out << ' ', turn, tum_turn_decimals);
    out << '\n';
}
}  // namespace rtob

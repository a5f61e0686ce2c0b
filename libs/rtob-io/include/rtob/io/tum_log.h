// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <rtob/io/log_contents.h>
#include <rtob/io/log_writer.h>
#include <rtob/io/text_file.h>

#include <memory>
#include <string>

namespace rtob
{
/// What the poses of a TUM file are in a log.
enum class PoseMeaning
{
    RobotPose,  ///< where the vehicle was: CObservationRobotPose, a result or the truth
    Odometry    ///< what the wheels said: CObservationOdometry, in the plane
};

/// Whether the file's first line that is no comment begins with a number. False when there is none.
/// Throws LogError for a file that cannot be read.
[[nodiscard]] bool is_tum_file(const std::string& file);

/// A TUM file as a log of poses with the label "pose" or "odometry". Throws LogError.
[[nodiscard]] std::unique_ptr<LogReader> open_tum_log(const std::string& file, PoseMeaning meaning);

/// Writes the poses of a log as TUM lines; all else is counted as lost. Positions to the
/// micrometre, the turn to 1e-9. A motion becomes the sum of all so far, at the next observation's
/// stamp.
class TumLogWriter : public LogWriter
{
 public:
    /// `contents` is what will be written. Throws std::runtime_error when there are no such poses,
    /// or those of several sensors.
    TumLogWriter(const std::string& file, const LogContents& contents, PoseMeaning meaning);

    void write(const LogEntry& entry) override;
    void commit() override { out_.commit(); }

 private:
    void writeObservation(const mrpt::obs::CObservation& observation);
    void writePose(const mrpt::obs::CObservation& observation, const mrpt::poses::CPose3D& pose);

    PoseMeaning meaning_;
    TextFile out_;
    Pose2 pose_odom_vehicle_;
    bool moved_ = false;  ///< since the last pose that was written
};
}  // namespace rtob

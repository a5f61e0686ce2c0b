// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <rtob/io/log_writer.h>
#include <rtob/io/object_file.h>

namespace rtob
{
/// An MRPT rawlog of observations, packed by gzip. Observations are kept as they are. A motion
/// becomes CObservationOdometry ("odometry"), the sum of all motions so far, just before the next
/// observation and with its stamp: motions have none of their own.
class RawlogWriter : public LogWriter
{
 public:
    explicit RawlogWriter(const std::string& file) : out_(file) {}

    void write(const LogEntry& entry) override;
    void commit() override;

 private:
    void writeMotions(mrpt::Clock::time_point stamp);

    ObjectFile out_;
    Pose2 pose_odom_vehicle_;
    bool moved_ = false;  ///< since the last odometry that was written
    mrpt::Clock::time_point last_stamp_ = INVALID_TIMESTAMP;
};
}  // namespace rtob

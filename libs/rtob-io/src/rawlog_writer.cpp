// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/io/rawlog_writer.h>

#include "motion_pose.h"

namespace rtob
{
void RawlogWriter::write(const LogEntry& entry)
{
    if (entry.motion)
    {
        pose_odom_vehicle_ = compose(pose_odom_vehicle_, pose2_of(*entry.motion));
        moved_ = true;
        return;
    }
    last_stamp_ = entry.observation->timestamp;
    if (moved_) writeMotions(last_stamp_);
    out_.write(*entry.observation);
}

void RawlogWriter::writeMotions(mrpt::Clock::time_point stamp)
{
    mrpt::obs::CObservationOdometry odometry;
    odometry.timestamp = stamp;
    odometry.sensorLabel = "odometry";
    odometry.odometry = {pose_odom_vehicle_.x, pose_odom_vehicle_.y, pose_odom_vehicle_.yaw};
    out_.write(odometry);
    moved_ = false;
}

void RawlogWriter::commit()
{
    if (moved_) writeMotions(last_stamp_);
    out_.commit();
}
}  // namespace rtob

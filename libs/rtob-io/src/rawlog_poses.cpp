// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_poses.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <rtob/io/log_reader.h>

namespace rtob
{
namespace
{
using mrpt::obs::CObservationRobotPose;

StampedPose2 stamped_pose(const CObservationRobotPose& observation)
{
    const auto& pose_map_vehicle = observation.pose.mean;
    return {
        mrpt::Clock::toDouble(observation.timestamp),
        {pose_map_vehicle.x(), pose_map_vehicle.y(), wrap_angle(pose_map_vehicle.yaw())}};
}
}  // namespace

std::vector<StampedPose2> read_rawlog_poses(const std::string& file)
{
    std::vector<StampedPose2> poses;
    std::string label;
    const auto reader = open_log(file);
    while (const auto entry = reader->next())
    {
        const auto observation =
            std::dynamic_pointer_cast<CObservationRobotPose>(entry->observation);
        if (!observation) continue;
        const std::string number = "pose " + std::to_string(poses.size() + 1);
        if (poses.empty()) label = observation->sensorLabel;
        if (observation->sensorLabel != label)
            throw LogError(
                file, number,
                "poses of two sensors, '" + label + "' and '" + observation->sensorLabel + "'",
                "Keep those of one (rawlog-edit --remove-label)");
        if (observation->timestamp == INVALID_TIMESTAMP)
            throw LogError(file, number, "it has no time", "Record the log with stamps");
        poses.push_back(stamped_pose(*observation));
    }
    return poses;
}
}  // namespace rtob

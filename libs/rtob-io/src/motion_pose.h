// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/poses/CPose2D.h>
#include <rtob/core/pose2.h>

namespace rtob
{
[[nodiscard]] inline Pose2 pose2_of(const mrpt::poses::CPose2D& pose)
{
    return {pose.x(), pose.y(), pose.phi()};
}

/// How far the vehicle moved: the mean that `run` uses too.
[[nodiscard]] inline Pose2 pose2_of(const mrpt::obs::CActionRobotMovement2D& motion)
{
    return pose2_of(motion.poseChange->getMeanVal());
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/mavlink_messages.h>
#include <rtob/drivers/pose_carrier.h>

namespace rtob
{
/// A pose in the plane as the messages want it: z down, covariances as the upper triangle of x, y,
/// z, roll, pitch, yaw. What a laser in the plane cannot know is sent with a huge variance.
/// @param heading_rad of the map's x axis, clockwise from north
[[nodiscard]] mavlink::Odometry odometry_of(const TimedPose& pose, double heading_rad);
[[nodiscard]] mavlink::VisionPositionEstimate vision_estimate_of(
    const TimedPose& pose, double heading_rad);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/velocity_guard.h>
#include <rtob/drivers/autopilot_news.h>
#include <rtob/drivers/mavlink_messages.h>

#include <optional>

/// The guard's words in the autopilot's: FLU of the vehicle becomes NED and FRD.
namespace rtob
{
/// Measured by the autopilot, in the vehicle's axes; nothing where that is older than max_age_s.
[[nodiscard]] std::optional<VehicleMotion> motion_of(
    const AutopilotNews& news, double max_age_s, double now_s);

/// A velocity over ground and a yaw rate, height held: LOCAL_NED, so that it does not turn with the
/// vehicle while it is on its way.
/// @param heading_rad of the vehicle's nose, clockwise from the autopilot's north
[[nodiscard]] mavlink::SetPositionTargetLocalNed velocity_target(
    const Eigen::Vector2d& velocity_vehicle, double yaw_rate_radps, double heading_rad,
    double now_s);

/// The nearest thing in each of 72 sectors around the vehicle's middle, clockwise from its nose.
/// What autopilots misread is kept from them: nearer than min_m is told as 1 cm more than that,
/// "nothing" as 1 cm more than the laser's range; a post between two sectors is in both.
[[nodiscard]] mavlink::ObstacleDistance obstacle_distance(
    const GuardScan& scan, bool no_return_is_free, double min_m = 0.1);
}  // namespace rtob

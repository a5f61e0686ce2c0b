// SPDX-License-Identifier: BSD-3-Clause
#include "usable_input.h"

#include <cmath>

namespace rtob
{
namespace
{
// A faster motion is a fault of its sensor.
constexpr double kAbsurdSpeed_mps = 50;
constexpr double kAbsurdTurn_radps = 50;
}  // namespace

bool is_usable(const VehicleMotion& motion)
{
    return motion.velocity_vehicle.norm() < kAbsurdSpeed_mps &&
           std::abs(motion.yaw_rate_radps) < kAbsurdTurn_radps;  // false for NaN
}

bool is_usable(const GuardScan& scan)
{
    const Pose2& mount = scan.pose_vehicle_laser;
    return scan.ranges_m != nullptr && scan.beams > 0 && std::isfinite(scan.stamp_s) &&
           scan.sweep_s >= 0 && scan.sweep_s < DeadReckoning::kLongestGap_s &&
           std::isfinite(scan.first_bearing_rad) && std::isfinite(scan.step_rad) &&
           scan.max_range_m > 0 && std::isfinite(mount.x + mount.y + mount.yaw);
}

bool is_usable(const MapPose& pose)
{
    const Pose2& place = pose.pose_map_vehicle;
    return !pose.is_lost && std::isfinite(pose.stamp_s + place.x + place.y + place.yaw) &&
           pose.sigma_m >= 0 && std::isfinite(pose.sigma_m);
}
}  // namespace rtob

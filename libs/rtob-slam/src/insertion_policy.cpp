// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <rtob/core/option_checks.h>
#include <rtob/slam/insertion_policy.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
void InsertionOptions::validate() const
{
    require(distance_m >= 0, "distance_m", distance_m, ">= 0");
    require(angle_deg >= 0, "angle_deg", angle_deg, ">= 0");
    require(interval_s > 0, "interval_s", interval_s, "> 0");
}

InsertionPolicy::InsertionPolicy(const InsertionOptions& options) : options_(options)
{
    options_.validate();
}

bool InsertionPolicy::wants(
    const std::string& laser, double time_s, const Pose2& pose_map_vehicle) const
{
    const auto last = std::find_if(
        last_.begin(), last_.end(), [&](const Insertion& i) { return i.laser == laser; });
    if (last == last_.end() || (options_.distance_m == 0 && options_.angle_deg == 0)) return true;
    const Pose2 moved = between(last->pose_map_vehicle, pose_map_vehicle);
    return (options_.distance_m > 0 && std::hypot(moved.x, moved.y) >= options_.distance_m) ||
           (options_.angle_deg > 0 && std::abs(moved.yaw) >= mrpt::DEG2RAD(options_.angle_deg)) ||
           time_s - last->time_s >= options_.interval_s;
}

void InsertionPolicy::inserted(
    const std::string& laser, double time_s, const Pose2& pose_map_vehicle)
{
    for (Insertion& last : last_)
        if (last.laser == laser)
        {
            last.time_s = time_s;
            last.pose_map_vehicle = pose_map_vehicle;
            return;
        }
    last_.push_back({laser, time_s, pose_map_vehicle});
}
}  // namespace rtob

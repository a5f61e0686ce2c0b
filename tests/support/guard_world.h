// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <room.h>
#include <rtob/avoid/velocity_guard.h>

#include <algorithm>
#include <vector>

namespace rtob::test
{
/// A scan of a room, all beams at once; what is out of reach reads 0, or max_range_m.
struct RoomScan
{
    std::vector<float> ranges_m;
    GuardScan scan;

    RoomScan(
        const Room& room, const Pose2& pose_map_vehicle, double time_s, bool far_is_free = true)
    {
        const Laser laser;
        ranges_m = room.ranges(pose_map_vehicle, laser);
        if (far_is_free)
            for (float& range_m : ranges_m)
                if (range_m == 0) range_m = static_cast<float>(laser.max_range_m);
        scan.stamp_s = time_s;
        scan.step_rad = laser.step_rad;
        scan.ranges_m = ranges_m.data();
        scan.beams = ranges_m.size();
        scan.max_range_m = laser.max_range_m;
    }
};

inline MapPose known_pose(double time_s, const Pose2& pose_map_vehicle)
{
    MapPose pose;
    pose.stamp_s = time_s;
    pose.pose_map_vehicle = pose_map_vehicle;
    pose.is_lost = false;
    return pose;
}

inline VehicleMotion standing()
{
    return {};
}

inline VehicleMotion flying(double forward_mps, double left_mps)
{
    VehicleMotion motion;
    motion.velocity_vehicle = {forward_mps, left_mps};
    return motion;
}

/// A guard that stands in a room, has seen it and knows where it is.
inline VelocityGuard guard_in(
    const Room& room, const Pose2& pose_map_vehicle, const VehicleLimits& limits = {},
    const GuardOptions& options = {})
{
    VelocityGuard guard(limits, options);
    static_cast<void>(guard.decide(0, {0, 0}, standing()));
    const RoomScan seen(room, pose_map_vehicle, 0);
    guard.observe(seen.scan, known_pose(0, pose_map_vehicle));
    return guard;
}
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#include "guard_messages.h"

#include <rtob/drivers/autopilot_frames.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
using Eigen::Vector2d;

constexpr double kPi = 3.14159265358979323846;
constexpr std::uint8_t kLocalNed = 1, kBodyFrd = 12, kLaser = 0;
// Of SET_POSITION_TARGET_LOCAL_NED: leave position, acceleration and yaw aside; the velocity and
// the yaw rate count.
constexpr std::uint16_t kVelocityAndYawRate = 0x05C7;
constexpr std::uint16_t kUnknown = 65535;
constexpr int kSectors = 72;

std::uint32_t milliseconds(double time_s)
{
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(std::max(0.0, 1e3 * time_s)));
}

/// In centimetres; the sector's nearest so far or this one.
void put(std::uint16_t& sector, double range_m, int low_cm, int high_cm)
{
    const int range_cm = static_cast<int>(std::min(100 * range_m, 65000.0));
    const auto told = static_cast<std::uint16_t>(std::clamp(range_cm, low_cm, high_cm));
    sector = std::min(sector, told);  // unknown is the largest
}
}  // namespace

std::optional<VehicleMotion> motion_of(const AutopilotNews& news, double max_age_s, double now_s)
{
    if (!news.position.isYoungerThan(max_age_s, now_s) ||
        !news.attitude.isYoungerThan(max_age_s, now_s))
        return std::nullopt;
    const auto& position = news.position.message;
    const auto& attitude = news.attitude.message;
    const Vector3 velocity =
        turn_over(to_north({position.vx, position.vy, 0}, -double{attitude.yaw}));
    VehicleMotion motion;
    motion.velocity_vehicle = {velocity.x, velocity.y};
    motion.yaw_rate_radps = -attitude.yawspeed;
    return motion;
}

mavlink::SetPositionTargetLocalNed velocity_target(
    const Vector2d& velocity_vehicle, double yaw_rate_radps, double heading_rad, double now_s)
{
    const Vector3 velocity =
        to_north(turn_over(Vector3{velocity_vehicle.x(), velocity_vehicle.y(), 0}), heading_rad);
    mavlink::SetPositionTargetLocalNed target;
    target.time_boot_ms = milliseconds(now_s);
    target.vx = static_cast<float>(velocity.x);
    target.vy = static_cast<float>(velocity.y);
    target.yaw_rate = static_cast<float>(-yaw_rate_radps);
    target.type_mask = kVelocityAndYawRate;
    target.coordinate_frame = kLocalNed;
    return target;
}

mavlink::ObstacleDistance obstacle_distance(
    const GuardScan& scan, bool no_return_is_free, double min_m)
{
    mavlink::ObstacleDistance message;
    message.time_usec = static_cast<std::uint64_t>(std::max(0.0, 1e6 * scan.stamp_s));
    message.min_distance = static_cast<std::uint16_t>(std::lround(100 * min_m));
    message.max_distance =
        static_cast<std::uint16_t>(std::min(std::lround(100 * scan.max_range_m), 65000L));
    message.sensor_type = kLaser;
    message.increment = 360 / kSectors;
    message.increment_f = 360.0F / kSectors;
    message.frame = kBodyFrd;
    message.distances.fill(kUnknown);
    const Pose2& mount = scan.pose_vehicle_laser;
    for (std::size_t i = 0; i < scan.beams; ++i)
    {
        const float range_m = scan.ranges_m[i];
        const bool is_hit = range_m > 0 && range_m < scan.max_range_m;
        const bool is_free = range_m >= scan.max_range_m || (!is_hit && no_return_is_free);
        if (!is_hit && !is_free) continue;
        const double length_m = is_hit ? range_m : scan.max_range_m;
        const double bearing_rad =
            mount.yaw + scan.first_bearing_rad + static_cast<double>(i) * scan.step_rad;
        const Vector2d end(
            mount.x + length_m * std::cos(bearing_rad), mount.y + length_m * std::sin(bearing_rad));
        const double clockwise = -std::atan2(end.y(), end.x()) / (2 * kPi) * kSectors;
        const auto nearest = static_cast<int>(std::floor(clockwise + 0.5));
        const int low_cm = message.min_distance + 1;
        // The autopilot asks the sector beside this one, too.
        const int beside = is_hit ? 1 : 0;
        for (int sector = nearest - beside; sector <= nearest + beside; ++sector)
            put(message.distances[static_cast<std::size_t>((sector + 2 * kSectors) % kSectors)],
                is_hit ? end.norm() : 1e6, low_cm,
                is_hit ? message.max_distance : message.max_distance + 1);
    }
    return message;
}
}  // namespace rtob

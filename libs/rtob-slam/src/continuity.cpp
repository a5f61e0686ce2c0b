// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/continuity.h>
#include <rtob/slam/turned_points.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rtob
{
namespace
{
// Both scans lie in the map where they fit it: little is left to be moved.
constexpr int kIterations = 4;

constexpr std::size_t kDirections = 180;
// Before what the last scan saw, by more than the motion and noise in between explain.
constexpr float kNearerShare = 0.8F, kNearer_m = 0.2F;
// Someone who walks by fills a part of the view; what hangs before the laser fills it all.
constexpr double kIntruderWeight = 0.5;

/// The direction of a point as seen from the vehicle, and how far it is.
struct Bearing
{
    std::size_t direction;
    float range_m;
};

Bearing bearing_of(float x, float y)
{
    constexpr float two_pi = 6.2831853F;
    const float turn = std::atan2(y, x) / two_pi + 0.5F;  // [0, 1]
    return {static_cast<std::size_t>(turn * kDirections) % kDirections, std::hypot(x, y)};
}

/// [0, 1] of the points that stand where the older scan looked through.
double intruding_share(
    const Points& older_vehicle, const Points& newer_vehicle, const Pose2& pose_older_newer)
{
    std::array<float, kDirections> free_m{};  // 0: the older scan saw nothing there
    for (std::size_t i = 0; i < older_vehicle.size(); ++i)
    {
        const Bearing bearing = bearing_of(older_vehicle.x[i], older_vehicle.y[i]);
        float& free = free_m[bearing.direction];
        free = free == 0 ? bearing.range_m : std::min(free, bearing.range_m);
    }
    const auto c = static_cast<float>(std::cos(pose_older_newer.yaw));
    const auto s = static_cast<float>(std::sin(pose_older_newer.yaw));
    const auto x0 = static_cast<float>(pose_older_newer.x);
    const auto y0 = static_cast<float>(pose_older_newer.y);
    std::size_t intruding = 0;
    for (std::size_t i = 0; i < newer_vehicle.size(); ++i)
    {
        const float x = newer_vehicle.x[i], y = newer_vehicle.y[i];
        const Bearing bearing = bearing_of(x0 + c * x - s * y, y0 + s * x + c * y);
        intruding += bearing.range_m < kNearerShare * free_m[bearing.direction] - kNearer_m;
    }
    return static_cast<double>(intruding) /
           static_cast<double>(std::max<std::size_t>(1, newer_vehicle.size()));
}

IcpOptions quick(IcpOptions icp)
{
    icp.iterations = std::min(icp.iterations, kIterations);
    return icp;
}
}  // namespace

Continuity::Continuity(const IcpOptions& icp) : icp_(quick(icp)) {}

void Continuity::tracked(
    const std::string& laser, const Pose2& pose_map_vehicle, const Points& points_vehicle)
{
    laser_ = laser;
    tracked_at_ = pose_map_vehicle;
    tracked_vehicle_ = points_vehicle;
}

double Continuity::agreement(
    const std::string& laser, const Pose2& pose_map_vehicle, const Points& points_vehicle)
{
    if (laser != laser_ || tracked_vehicle_.size() == 0) return 1;
    turn_points(tracked_at_, tracked_vehicle_.view(), points_turned_);
    icp_.prepare(points_turned_.view(), reference_);
    turn_points(pose_map_vehicle, points_vehicle.view(), points_turned_);
    const IcpResult fit = icp_.align(
        points_turned_.view(), reference_,
        {pose_map_vehicle.x - tracked_at_.x, pose_map_vehicle.y - tracked_at_.y});
    const double intruding =
        intruding_share(tracked_vehicle_, points_vehicle, between(tracked_at_, pose_map_vehicle));
    return std::min(fit.known_share, 1 - kIntruderWeight * intruding);
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/sim/flight.h>

#include <algorithm>

namespace rtob::sim
{
namespace
{
constexpr double rad_per_deg = 3.14159265358979323846 / 180;
constexpr double hold_gain_per_s = 1.0;  // of position and height
constexpr double yaw_gain_per_s = 2.0;
constexpr double standing_mps = 0.05;  // below that a direction means nothing
}  // namespace

Pilot::Pilot(const FlightPlan& plan, const Pose3& start_map) : plan_(plan), start_map_(start_map)
{
    if (plan_.route.empty()) return;
    addLeg({{start_map.x, start_map.y}, start_map.z, 0}, plan_.route.front());
    for (std::size_t i = 1; i < plan_.route.size(); ++i) addLeg(plan_.route[i - 1], plan_.route[i]);
    if (!plan_.repeat || plan_.route.size() < 2) return;
    // Rounds go from the first waypoint to the first.
    repeats_from_s_ = legs_.front().start_s + legs_.front().move_s + legs_.front().to.hold_s;
    addLeg(plan_.route.back(), plan_.route.front());
}

void Pilot::addLeg(const Waypoint& from, const Waypoint& to)
{
    const double way_m = length(to.at_map - from.at_map);
    const double climb_m = std::abs(to.altitude_m - from.altitude_m);
    const double move_s = std::max(way_m / plan_.speed_mps, climb_m / plan_.climb_mps);
    legs_.push_back({end_s_, move_s, from, to});
    end_s_ += move_s + to.hold_s;
}

FlightTarget Pilot::target(double time_s) const
{
    if (legs_.empty()) return {{start_map_.x, start_map_.y}, start_map_.z, 0, 0, 0};
    const double round_s = end_s_ - repeats_from_s_;
    if (repeats_from_s_ > 0 && time_s >= end_s_)
        time_s = repeats_from_s_ + std::fmod(time_s - repeats_from_s_, round_s);
    const auto next = std::upper_bound(
        legs_.begin(), legs_.end(), time_s,
        [](double t, const Leg& leg) { return t < leg.start_s; });
    const Leg& leg = *std::prev(next);
    const double moved_s = time_s - leg.start_s;
    if (moved_s >= leg.move_s) return {leg.to.at_map, leg.to.altitude_m, 0, 0, 0};
    const double share = moved_s / leg.move_s;
    const Point2 way = leg.to.at_map - leg.from.at_map;
    const double climb_m = leg.to.altitude_m - leg.from.altitude_m;
    return {
        leg.from.at_map + share * way, leg.from.altitude_m + share * climb_m, way.x / leg.move_s,
        way.y / leg.move_s, climb_m / leg.move_s};
}

VelocityCommand Pilot::command(double time_s, const VehicleState& state, VehicleKind kind) const
{
    const auto& pose = state.pose_map_vehicle;
    const FlightTarget goal = target(time_s);
    const Point2 off = goal.at_map - Point2{pose.x, pose.y};
    const Point2 wished{
        goal.vx_map_mps + hold_gain_per_s * off.x, goal.vy_map_mps + hold_gain_per_s * off.y};
    const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
    VelocityCommand command;
    command.forward_mps = c * wished.x + s * wished.y;
    if (kind == VehicleKind::Multirotor)
        command.left_mps = -s * wished.x + c * wished.y;
    else
        command.forward_mps = std::max(0.0, command.forward_mps);
    command.climb_mps = goal.climb_mps + hold_gain_per_s * (goal.altitude_m - pose.z);
    const double speed_mps = std::hypot(goal.vx_map_mps, goal.vy_map_mps);
    command.yaw_rate_radps = yawRate(time_s, wished, speed_mps, pose.yaw, kind);
    return command;
}

double Pilot::yawRate(
    double time_s, Point2 wished_mps, double speed_mps, double yaw_rad, VehicleKind kind) const
{
    const double spin_radps = plan_.yaw_rate_dps * rad_per_deg;
    double yaw_goal = start_map_.yaw, feed_forward = 0;
    if (kind == VehicleKind::Differential || plan_.heading == Heading::Ahead)
    {
        if (std::max(speed_mps, kind == VehicleKind::Differential ? length(wished_mps) : 0.0) <
            standing_mps)
            return 0;
        yaw_goal = std::atan2(wished_mps.y, wished_mps.x);
    }
    else if (plan_.heading == Heading::Spin)
    {
        yaw_goal += spin_radps * time_s;
        feed_forward = spin_radps;
    }
    return feed_forward + yaw_gain_per_s * wrap_angle(yaw_goal - yaw_rad);
}
}  // namespace rtob::sim

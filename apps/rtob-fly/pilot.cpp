// SPDX-License-Identifier: BSD-3-Clause
#include "pilot.h"

#include <cmath>

namespace rtob::fly
{
using Eigen::Vector2d;

namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr double kScriptedSpeed_mps = 1.2;
constexpr double kArrived_m = 0.7;
constexpr double kPatience_s = 12;  // then the next place, reached or not
constexpr double kFarthestLook_m = 8;

Vector2d vector(double bearing_rad, double length)
{
    return {length * std::cos(bearing_rad), length * std::sin(bearing_rad)};
}

Vector2d place_of(const sim::Simulation& simulation)
{
    const auto& pose = simulation.state().pose_map_vehicle;
    return {pose.x, pose.y};
}
}  // namespace

Pilot::Pilot(PilotKind kind, std::vector<Vector2d> route, std::uint64_t seed)
    : kind_(kind), route_map_(std::move(route)), random_(seed)
{
    if (!route_map_.empty()) leg_ = random_.below(route_map_.size());
    if (kind == PilotKind::Straight) leg_ = 0;
}

StickInput Pilot::fly(double time_s, const sim::Simulation& simulation)
{
    if (kind_ == PilotKind::Scripted || kind_ == PilotKind::Straight)
        pointToRoute(time_s, place_of(simulation));
    else if (time_s >= next_thought_s_)
        think(time_s, simulation);
    return input_;
}

void Pilot::pointToRoute(double time_s, const Vector2d& place_map)
{
    if (route_map_.empty()) return;
    const bool keeps_direction = kind_ == PilotKind::Straight && !input_.wish_map.isZero();
    if (keeps_direction) return;
    Vector2d way = route_map_[leg_] - place_map;
    if (way.norm() < kArrived_m || time_s - leg_began_s_ > kPatience_s)
    {
        leg_ = (leg_ + 1) % route_map_.size();
        leg_began_s_ = time_s;
        way = route_map_[leg_] - place_map;
    }
    input_.wish_map = kScriptedSpeed_mps * way.normalized();
    if (kind_ == PilotKind::Scripted) input_.yaw_rate_radps = 0.5 * std::sin(0.4 * time_s);
}

void Pilot::think(double time_s, const sim::Simulation& simulation)
{
    const bool is_malicious = kind_ == PilotKind::Malicious;
    next_thought_s_ =
        time_s + (is_malicious ? 0.1 + 2 * random_.uniform() : 0.3 + 3 * random_.uniform());
    input_.yaw_rate_radps = (random_.uniform() - 0.5) * (is_malicious ? 4 : 2);
    if (!is_malicious)
        input_.wish_map = vector(2 * kPi * random_.uniform(), 2 * random_.uniform());
    else
        pointAtNearest(simulation);
}

/// At the nearest thing, at one of the things around, or back again; as fast as it can.
void Pilot::pointAtNearest(const sim::Simulation& simulation)
{
    const double choice = random_.uniform();
    const double speed_mps = random_.uniform() < 0.2 ? 100 : 2;
    if (choice < 0.2)
    {
        input_.wish_map = -input_.wish_map;
        return;
    }
    const auto& pose = simulation.state().pose_map_vehicle;
    double nearest_m = kFarthestLook_m, bearing_rad = 2 * kPi * random_.uniform();
    for (int i = 0; i < 72 && choice < 0.8; ++i)
    {
        const double looked_rad = 2 * kPi * i / 72;
        const Vector2d direction = vector(looked_rad, 1);
        sim::Beam beam;
        beam.origin_map = {pose.x, pose.y};
        beam.z_m = pose.z;
        beam.direction_map = {direction.x(), direction.y()};
        const double distance_m = simulation.scene().cast(beam).distance_m;
        // In half of the cases not the nearest but the farthest: a long run at a wall.
        const double badness_m = choice < 0.5 ? distance_m : kFarthestLook_m - distance_m;
        if (badness_m >= nearest_m) continue;
        nearest_m = badness_m;
        bearing_rad = looked_rad;
    }
    input_.wish_map = vector(bearing_rad + 0.3 * (random_.uniform() - 0.5), speed_mps);
}
}  // namespace rtob::fly

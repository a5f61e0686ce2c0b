// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/velocity_guard.h>
#include <rtob/core/random.h>
#include <rtob/sim/simulation.h>

#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace rtob::fly
{
enum class PilotKind
{
    Scripted,   ///< points to one place after the other, without looking
    Random,     ///< a new direction and speed every now and then
    Malicious,  ///< steers at what is nearest, fast, and jerks the stick
    Straight    ///< one direction only
};

constexpr auto enum_names(PilotKind)
{
    return std::array<std::pair<PilotKind, std::string_view>, 4>{
        {{PilotKind::Scripted, "scripted"},
         {PilotKind::Random, "random"},
         {PilotKind::Malicious, "malicious"},
         {PilotKind::Straight, "straight"}}};
}

/// What the sticks say.
struct StickInput
{
    Eigen::Vector2d wish_map = Eigen::Vector2d::Zero();  ///< m/s
    double yaw_rate_radps = 0;
};

/// Knows the truth, and takes no care at all.
class Pilot
{
 public:
    /// @param route places that Scripted points to, and where Straight goes: to the first one
    Pilot(PilotKind kind, std::vector<Eigen::Vector2d> route, std::uint64_t seed);

    [[nodiscard]] StickInput fly(double time_s, const sim::Simulation& simulation);

 private:
    void think(double time_s, const sim::Simulation& simulation);
    void pointToRoute(double time_s, const Eigen::Vector2d& place_map);
    void pointAtNearest(const sim::Simulation& simulation);

    PilotKind kind_;
    std::vector<Eigen::Vector2d> route_map_;
    Random random_;
    StickInput input_;
    double next_thought_s_ = 0, leg_began_s_ = 0;
    std::size_t leg_ = 0;
};
}  // namespace rtob::fly

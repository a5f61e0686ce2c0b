// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <guard_situation.h>

#include <limits>

namespace rtob::test
{
inline constexpr double kSimulationStep_s = 0.01;

/// One way in which a vehicle within its limits may carry out what it is told.
struct VehicleBehaviour
{
    double acceleration_mps2 = 1;
    double response_s = 0;
    double next_decision_s = 0;       ///< when it is told to stop
    std::vector<double> latencies_s;  ///< of each command, in the order given, the stop last
};

inline VehicleBehaviour drawn_behaviour(
    const VehicleLimits& limits, std::size_t commands, Random& random)
{
    // The extremes are where things go wrong.
    const auto extreme = [&](double low, double high)
    {
        const auto pick = random.below(3);
        return pick == 0 ? low : pick == 1 ? high : low + (high - low) * random.uniform();
    };
    VehicleBehaviour behaviour;
    behaviour.acceleration_mps2 = limits.braking() * extreme(1, 4);
    behaviour.response_s = limits.response_s * extreme(0, 1);
    behaviour.next_decision_s = limits.period_s * extreme(0, 1);
    for (std::size_t i = 0; i < commands; ++i)
        behaviour.latencies_s.push_back(limits.latency_s * extreme(0, 1));
    return behaviour;
}

/// A plain simulation: where the vehicle's middle is every kSimulationStep_s until it stands, when
/// after the answer's command it is told to stop. The last command to take effect is followed.
inline std::vector<Eigen::Vector2d> stopping_path(
    const GuardSituation& situation, const GuardAnswer& answer, const Eigen::Vector2d& command,
    const VehicleBehaviour& behaviour)
{
    constexpr double step_s = kSimulationStep_s, enough_s = 20;
    std::vector<double> effects_s;
    std::vector<Eigen::Vector2d> commands = answer.earlier_commands;
    for (std::size_t i = 0; i < answer.earlier_s.size(); ++i)
        effects_s.push_back(answer.earlier_s[i] + behaviour.latencies_s[i]);
    commands.push_back(command);
    effects_s.push_back(behaviour.latencies_s[commands.size() - 1]);
    commands.emplace_back(0, 0);
    effects_s.push_back(behaviour.next_decision_s + behaviour.latencies_s[commands.size() - 1]);
    // A later command never takes effect before an earlier one.
    for (std::size_t i = 1; i < effects_s.size(); ++i)
        effects_s[i] = std::max(effects_s[i], effects_s[i - 1]);

    std::vector<Eigen::Vector2d> path{{0, 0}};
    Eigen::Vector2d velocity = situation.velocity, place{0, 0};
    for (double time_s = 0; time_s < enough_s; time_s += step_s)
    {
        Eigen::Vector2d target = situation.velocity;
        for (std::size_t i = 0; i < commands.size(); ++i)
            if (effects_s[i] <= time_s) target = commands[i];
        const double share =
            behaviour.response_s > 0 ? 1 - std::exp(-step_s / behaviour.response_s) : 1;
        Eigen::Vector2d change = (target - velocity) * share;
        const double most = behaviour.acceleration_mps2 * step_s;
        if (change.norm() > most) change *= most / change.norm();
        place += step_s * (velocity + change / 2);
        velocity += change;
        path.push_back(place);
        if (time_s > effects_s.back() && velocity.norm() < 1e-3) break;
    }
    return path;
}

[[nodiscard]] inline double fastest_of(
    const GuardSituation& situation, const std::vector<Eigen::Vector2d>& commands)
{
    double fastest = situation.velocity.norm();
    for (const auto& velocity : commands) fastest = std::max(fastest, velocity.norm());
    return fastest;
}

/// A lower bound of how near an obstacle the vehicle may come even if it is told to stop at once:
/// from the definition, by a grid over mixtures of pairs of the velocities that still act.
inline double nearest_when_stopping(
    const GuardSituation& situation, const GuardAnswer& answer, const Eigen::Vector2d& obstacle)
{
    constexpr int kSteps = 12;
    std::vector<Eigen::Vector2d> acting = answer.earlier_commands;
    acting.push_back(situation.velocity);
    const double fastest = fastest_of(situation, acting);
    const VehicleLimits& limits = situation.limits;
    const double time_s = limits.latency_s + limits.response() + fastest / (2 * limits.braking());
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& a : acting)
        for (const auto& b : acting)
            for (int i = 0; i <= kSteps; ++i)
                for (int k = 0; k <= kSteps - i; ++k)
                {
                    const Eigen::Vector2d place = time_s / kSteps * (i * a + k * b);
                    nearest = std::min(nearest, (obstacle - place).norm());
                }
    return nearest - time_s * fastest / kSteps;  // a place of the grid is nearer than that
}

/// Numbers of the obstacles that a path may come nearer to than keep_m.
inline std::vector<std::size_t> near_path(
    const std::vector<Eigen::Vector2d>& obstacles, const std::vector<Eigen::Vector2d>& path,
    double keep_m)
{
    double reach_m = 0;
    for (const auto& place : path) reach_m = std::max(reach_m, place.norm());
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < obstacles.size(); ++k)
        if (obstacles[k].norm() < reach_m + keep_m) numbers.push_back(k);
    return numbers;
}

/// What even a stop at once may come too near to is not to be approached: the vehicle may still
/// stop short of it.
inline std::string approach(
    const GuardSituation& situation, const GuardAnswer& answer, const VehicleBehaviour& behaviour)
{
    const Eigen::Vector2d& command = answer.decision.velocity_vehicle;
    if (command.isZero()) return {};
    // So that rounding decides nothing.
    const double near_m = std::max(0.0, situation.limits.clearance() - 1e-3);
    const auto path = stopping_path(situation, answer, {0, 0}, behaviour);
    for (const std::size_t k : near_path(answer.obstacles, path, near_m))
        for (const auto& place : path)
        {
            const Eigen::Vector2d& obstacle = answer.obstacles[k];
            if ((obstacle - place).squaredNorm() >= near_m * near_m) continue;
            if (command.dot(obstacle) <= 1e-4) break;
            return "command " + text_of(command) + " leads towards the obstacle at " +
                   text_of(obstacle) + ", which a stop at once is not sure to keep clear of";
        }
    return {};
}

/// What is wrong with the guard's answer to a situation; empty when nothing is.
inline std::string complaint(
    const GuardSituation& situation, const GuardAnswer& answer, std::uint64_t seed)
{
    constexpr int kBehaviours = 4;
    const Eigen::Vector2d& command = answer.decision.velocity_vehicle;
    if (!(command.norm() <= situation.wish.norm() + 1e-12)) return "faster than wished";
    if (command.norm() > 0)
    {
        const double bend_rad = std::acos(std::clamp(
            command.dot(situation.wish) / command.norm() / situation.wish.norm(), -1.0, 1.0));
        if (bend_rad > situation_options().guide_deg * M_PI / 180 + 1e-6) return "bent too much";
    }
    Random random(seed);
    const double keep_m = situation.limits.clearance();
    const double step_m = kSimulationStep_s *
                          std::max(fastest_of(situation, answer.earlier_commands), command.norm());
    std::vector<double> excused_m(answer.obstacles.size(), -1);  // computed where needed
    for (int i = 0; i < kBehaviours; ++i)
    {
        const auto behaviour =
            drawn_behaviour(situation.limits, answer.earlier_commands.size() + 2, random);
        if (const std::string wrong = approach(situation, answer, behaviour); !wrong.empty())
            return wrong;
        const auto path = stopping_path(situation, answer, command, behaviour);
        const auto numbers = near_path(answer.obstacles, path, keep_m);
        const double near_m = std::max(0.0, keep_m - step_m);
        for (const auto& place : path)
            for (const std::size_t k : numbers)
            {
                if ((answer.obstacles[k] - place).squaredNorm() >= near_m * near_m) continue;
                const double distance_m = (answer.obstacles[k] - place).norm() + step_m;
                if (excused_m[k] < 0)
                    excused_m[k] = std::max(
                        nearest_when_stopping(situation, answer, answer.obstacles[k]), 0.0);
                if (distance_m >= excused_m[k]) continue;
                std::ostringstream text;
                text << "comes to " << distance_m << " m of the obstacle at "
                     << text_of(answer.obstacles[k]) << ", where a stop at once keeps "
                     << excused_m[k] << "; command " << text_of(command);
                return text.str();
            }
    }
    return {};
}

inline std::string complaint(const GuardSituation& situation, std::uint64_t seed)
{
    return complaint(situation, answer_to(situation), seed);
}
}  // namespace rtob::test

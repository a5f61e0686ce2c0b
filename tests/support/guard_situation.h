// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/velocity_guard.h>
#include <rtob/core/random.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace rtob::test
{
/// What a guard may meet, in the vehicle's frame. Small enough to be printed and to be made
/// smaller.
struct GuardSituation
{
    struct Beam
    {
        int degree = 0;
        float range_m = 0;
    };
    VehicleLimits limits;
    std::vector<Beam> seen;        ///< by the newest scan
    std::vector<Beam> remembered;  ///< by the scan before, where the newest one has no return
    std::vector<Eigen::Vector2d> earlier_wishes;  ///< oldest first, over the last latency
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    Eigen::Vector2d wish = Eigen::Vector2d::Zero();
};

/// What the guard was told and what it said.
struct GuardAnswer
{
    std::vector<Eigen::Vector2d> obstacles;
    std::vector<double> earlier_s;  ///< before now, negative
    std::vector<Eigen::Vector2d> earlier_commands;
    GuardDecision decision;
};

inline Eigen::Vector2d place_of(const GuardSituation::Beam& beam)
{
    const double bearing_rad = beam.degree * M_PI / 180;
    return {beam.range_m * std::cos(bearing_rad), beam.range_m * std::sin(bearing_rad)};
}

/// Policy allow: these situations are about obstacles. A memory that never fades.
inline GuardOptions situation_options()
{
    GuardOptions options;
    options.unknown = UnknownPolicy::Allow;
    options.memory_points = 400;
    options.memory_s = 1e6;
    options.max_scan_age_s = 1;
    return options;
}

inline void observe_beams(
    VelocityGuard& guard, const std::vector<GuardSituation::Beam>& beams, double stamp_s)
{
    std::vector<float> ranges_m(360, 0.0F);
    for (const auto& beam : beams) ranges_m[static_cast<std::size_t>(beam.degree)] = beam.range_m;
    GuardScan scan;
    scan.stamp_s = stamp_s;
    scan.step_rad = M_PI / 180;
    scan.ranges_m = ranges_m.data();
    scan.beams = ranges_m.size();
    scan.max_range_m = 100;
    MapPose pose;
    pose.stamp_s = stamp_s;
    pose.is_lost = false;
    guard.observe(scan, pose);
}

/// The vehicle stands at the origin until now, and now has its velocity.
inline GuardAnswer answer_to(const GuardSituation& situation)
{
    constexpr double kNow_s = 10;
    VelocityGuard guard(situation.limits, situation_options());
    GuardAnswer answer;
    const VehicleMotion standing;
    static_cast<void>(guard.decide(kNow_s - 0.9, {0, 0}, standing));
    observe_beams(guard, situation.remembered, kNow_s - 0.8);
    observe_beams(guard, situation.seen, kNow_s - 0.7);
    const auto count = static_cast<double>(situation.earlier_wishes.size());
    for (std::size_t i = 0; i < situation.earlier_wishes.size(); ++i)
    {
        const double earlier_s =
            -situation.limits.latency_s * (count - static_cast<double>(i)) / count;
        const auto said = guard.decide(kNow_s + earlier_s, situation.earlier_wishes[i], standing);
        answer.earlier_s.push_back(earlier_s);
        answer.earlier_commands.push_back(said.velocity_vehicle);
    }
    static_cast<void>(guard.decide(kNow_s - 1e-9, {0, 0}, standing));
    answer.earlier_s.push_back(-1e-9);
    answer.earlier_commands.emplace_back(0, 0);
    VehicleMotion motion;
    motion.velocity_vehicle = situation.velocity;
    answer.decision = guard.decide(kNow_s, situation.wish, motion);
    for (const auto* beams : {&situation.seen, &situation.remembered})
        for (const auto& beam : *beams) answer.obstacles.push_back(place_of(beam));
    return answer;
}

/// Drawn to be hard: obstacles at about the stopping distance, wishes and velocities towards them.
class SituationDraw
{
 public:
    explicit SituationDraw(std::uint64_t seed) : random_(seed) {}

    GuardSituation draw()
    {
        GuardSituation situation;
        situation.limits = drawLimits();
        const double speed_mps = 3 * random_.uniform() * random_.uniform();
        situation.velocity = vector(random_.below(4) == 0 ? 0 : speed_mps);
        for (std::size_t i = random_.below(4); i > 0; --i)
            situation.earlier_wishes.push_back(vector(2 * random_.uniform()));
        situation.wish = vector(random_.below(10) == 0 ? 100 : 2.5 * random_.uniform());
        const double reach_m =
            situation.limits.clearance() + 0.05 + 3 * random_.uniform() * random_.uniform();
        drawObstacles(reach_m, situation);
        return situation;
    }

 private:
    [[nodiscard]] double between(double low, double high)
    {
        return low + (high - low) * random_.uniform();
    }
    [[nodiscard]] Eigen::Vector2d vector(double length)
    {
        const double bearing_rad = between(-M_PI, M_PI);
        return {length * std::cos(bearing_rad), length * std::sin(bearing_rad)};
    }
    [[nodiscard]] VehicleLimits drawLimits()
    {
        VehicleLimits limits;
        limits.radius_m = between(0.1, 0.6);
        limits.margin_m = between(0, 0.3);
        limits.acceleration_mps2 = between(0.5, 5);
        limits.derating = between(0.5, 1);
        limits.latency_s = between(0, 0.5);
        limits.response_s = between(0, 0.5);
        limits.period_s = between(0.02, 0.2);
        return limits;
    }
    /// Walls and posts; each beam hits one thing, which is seen or only remembered.
    void drawObstacles(double reach_m, GuardSituation& situation)
    {
        std::vector<float> nearest_m(360, 0.0F);
        std::vector<bool> is_remembered(360, false);
        for (std::size_t thing = random_.below(5); thing > 0; --thing)
        {
            const bool is_wall = random_.below(2) == 0, is_old = random_.below(3) == 0;
            const auto middle = static_cast<int>(random_.below(360));
            const int half = is_wall ? 60 : static_cast<int>(random_.below(4));
            const double distance_m = reach_m * between(0.6, 1.6);
            for (int off = -half; off <= half; ++off)
            {
                const auto beam = static_cast<std::size_t>((middle + off + 360) % 360);
                const auto range_m = static_cast<float>(distance_m / std::cos(off * M_PI / 180));
                if (nearest_m[beam] > 0 && nearest_m[beam] <= range_m) continue;
                nearest_m[beam] = range_m;
                is_remembered[beam] = is_old;
            }
        }
        for (int degree = 0; degree < 360; ++degree)
        {
            const auto beam = static_cast<std::size_t>(degree);
            if (nearest_m[beam] == 0) continue;
            auto& list = is_remembered[beam] ? situation.remembered : situation.seen;
            list.push_back({degree, nearest_m[beam]});
        }
        // A post of one beam between seen ones is taken for replaced: such are not remembered.
        hideBesideSeen(situation);
    }
    static void hideBesideSeen(GuardSituation& situation)
    {
        const auto is_beside_seen = [&](const GuardSituation::Beam& old)
        {
            return std::any_of(
                situation.seen.begin(), situation.seen.end(),
                [&](const GuardSituation::Beam& seen)
                {
                    const int apart = std::abs(old.degree - seen.degree) % 360;
                    return std::min(apart, 360 - apart) <= 3;
                });
        };
        auto& old = situation.remembered;
        old.erase(std::remove_if(old.begin(), old.end(), is_beside_seen), old.end());
    }

    Random random_;
};

inline std::string text_of(const Eigen::Vector2d& vector)
{
    std::ostringstream text;
    text.precision(17);
    text << "{" << vector.x() << ", " << vector.y() << "}";
    return text.str();
}

/// As an initialiser that can be pasted into a test.
inline std::string text_of(const GuardSituation& situation)
{
    const VehicleLimits& l = situation.limits;
    std::ostringstream text;
    text.precision(17);
    text << "GuardSituation s;\ns.limits.radius_m = " << l.radius_m
         << ";\ns.limits.margin_m = " << l.margin_m
         << ";\ns.limits.acceleration_mps2 = " << l.acceleration_mps2
         << ";\ns.limits.derating = " << l.derating << ";\ns.limits.latency_s = " << l.latency_s
         << ";\ns.limits.response_s = " << l.response_s << ";\ns.limits.period_s = " << l.period_s
         << ";\n";
    const auto list = [&](const char* name, const std::vector<GuardSituation::Beam>& beams)
    {
        text << "s." << name << " = {";
        for (const auto& beam : beams) text << "{" << beam.degree << ", " << beam.range_m << "F}, ";
        text << "};\n";
    };
    list("seen", situation.seen);
    list("remembered", situation.remembered);
    text << "s.earlier_wishes = {";
    for (const auto& wish : situation.earlier_wishes) text << text_of(wish) << ", ";
    text << "};\ns.velocity = " << text_of(situation.velocity)
         << ";\ns.wish = " << text_of(situation.wish) << ";\n";
    return text.str();
}

/// The smallest situation, by leaving things out one after the other, for which `fails` holds.
template <class Fails>
GuardSituation shrunk(GuardSituation situation, Fails&& fails)
{
    const auto try_it = [&](auto&& change)
    {
        GuardSituation smaller = situation;
        change(smaller);
        if (!fails(smaller)) return false;
        situation = smaller;
        return true;
    };
    const auto without = [&](auto GuardSituation::*list)
    {
        for (std::size_t step = (situation.*list).size(); step >= 1; step /= 2)
            for (std::size_t i = 0; i + step <= (situation.*list).size();)
                if (!try_it(
                        [&](GuardSituation& smaller)
                        {
                            const auto begin =
                                (smaller.*list).begin() + static_cast<std::ptrdiff_t>(i);
                            (smaller.*list).erase(begin, begin + static_cast<std::ptrdiff_t>(step));
                        }))
                    ++i;
    };
    without(&GuardSituation::seen);
    without(&GuardSituation::remembered);
    without(&GuardSituation::earlier_wishes);
    try_it([](GuardSituation& smaller) { smaller.velocity.setZero(); });
    return situation;
}
}  // namespace rtob::test

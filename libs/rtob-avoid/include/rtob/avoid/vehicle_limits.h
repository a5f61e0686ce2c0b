// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace rtob
{
/// What the guard may count on: the vehicle's size and how fast it does what it is told.
struct VehicleLimits
{
    double radius_m = 0.45;
    double margin_m = 0.15;
    double max_speed_mps = 2.0;
    double acceleration_mps2 = 2.0;
    double derating = 0.7;
    double jerk_mps3 = 0;
    double latency_s = 0.25;
    double response_s = 0.25;
    double period_s = 0.1;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("radius_m", s.radius_m, "of the disc that holds the whole vehicle; > 0");
        visit(
            "margin_m", s.margin_m,
            "kept free around that disc; must hold range noise, velocity error and gusts; >= 0");
        visit("max_speed_mps", s.max_speed_mps, "no command is faster; > 0, at most 20");
        visit(
            "acceleration_mps2", s.acceleration_mps2,
            "that the vehicle is said to reach when it brakes; > 0");
        visit("derating", s.derating, "share of that acceleration to count on; (0, 1]");
        visit("jerk_mps3", s.jerk_mps3, "how fast it builds up acceleration; 0: at once; >= 0");
        visit(
            "latency_s", s.latency_s,
            "longest time from a decision until the vehicle begins to act on it; >= 0");
        visit(
            "response_s", s.response_s,
            "time constant of the vehicle's velocity once it acts; >= 0");
        visit("period_s", s.period_s, "longest time from one decision to the next; > 0");
    }
    void validate() const;

    /// Between the vehicle's middle and an obstacle.
    [[nodiscard]] double clearance() const { return radius_m + margin_m; }
    [[nodiscard]] double braking() const { return derating * acceleration_mps2; }
    /// The time constant with what a limited jerk adds to it: once to end the acceleration that the
    /// vehicle has, and half of that to build up the new one.
    [[nodiscard]] double response() const
    {
        return response_s + (jerk_mps3 > 0 ? 1.5 * acceleration_mps2 / jerk_mps3 : 0);
    }
};
}  // namespace rtob

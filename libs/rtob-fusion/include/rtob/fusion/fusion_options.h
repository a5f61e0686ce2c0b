// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace rtob
{
/// The motion filter's noises; one sigma each.
struct FusionOptions
{
    double speed_change_mps = 1;
    double turn_change_degps = 180;
    double gyro_noise_degps = 0.5;
    double gyro_bias_degps = 1;
    double gyro_drift_degps = 0.02;
    double flow_noise_mps = 0.1;
    double flow_scale_error = 0.05;
    double odometry_noise_m = 0.02;
    double odometry_noise_deg = 1;
    double scan_noise_m = 0.01;
    double scan_noise_deg = 0.2;
    double gate_chance = 1e-4;
    double history_s = 1;
    double max_climb_mps = 5;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("speed_change_mps", s.speed_change_mps, "of the vehicle after 1 s, each axis; > 0");
        visit("turn_change_degps", s.turn_change_degps, "of the vehicle after 1 s; > 0");
        visit("gyro_noise_degps", s.gyro_noise_degps, "of a yaw rate; > 0");
        visit("gyro_bias_degps", s.gyro_bias_degps, "of yaw rates at the start; > 0");
        visit("gyro_drift_degps", s.gyro_drift_degps, "of the bias after 1 s; >= 0");
        visit("flow_noise_mps", s.flow_noise_mps, "of a velocity over ground; > 0");
        visit("flow_scale_error", s.flow_scale_error, "and what each m/s adds to it; >= 0");
        visit("odometry_noise_m", s.odometry_noise_m, "after 1 m, grows as its root; > 0");
        visit(
            "odometry_noise_deg", s.odometry_noise_deg,
            "after 1 m or 90 degrees, grows as the root; > 0");
        visit("scan_noise_m", s.scan_noise_m, "of a scan's pose, beyond the match's own; > 0");
        visit("scan_noise_deg", s.scan_noise_deg, "of a scan's pose, beyond the match's own; > 0");
        visit(
            "gate_chance", s.gate_chance,
            "with which a good reading is refused: the NIS gate; (0, 0.5)");
        visit(
            "history_s", s.history_s,
            "readings may be so late; the filter replays from there; > 0");
        visit("max_climb_mps", s.max_climb_mps, "a height that changes faster is refused; > 0");
    }
    void validate() const;
};
}  // namespace rtob

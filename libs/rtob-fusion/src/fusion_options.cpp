// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/fusion/fusion_options.h>

namespace rtob
{
void FusionOptions::validate() const
{
    require(speed_change_mps > 0, "speed_change_mps", speed_change_mps, "> 0");
    require(turn_change_degps > 0, "turn_change_degps", turn_change_degps, "> 0");
    require(gyro_noise_degps > 0, "gyro_noise_degps", gyro_noise_degps, "> 0");
    require(gyro_bias_degps > 0, "gyro_bias_degps", gyro_bias_degps, "> 0");
    require(gyro_drift_degps >= 0, "gyro_drift_degps", gyro_drift_degps, ">= 0");
    require(flow_noise_mps > 0, "flow_noise_mps", flow_noise_mps, "> 0");
    require(flow_scale_error >= 0, "flow_scale_error", flow_scale_error, ">= 0");
    require(odometry_noise_m > 0, "odometry_noise_m", odometry_noise_m, "> 0");
    require(odometry_noise_deg > 0, "odometry_noise_deg", odometry_noise_deg, "> 0");
    require(scan_noise_m > 0, "scan_noise_m", scan_noise_m, "> 0");
    require(scan_noise_deg > 0, "scan_noise_deg", scan_noise_deg, "> 0");
    require(gate_chance > 0 && gate_chance < 0.5, "gate_chance", gate_chance, "in (0, 0.5)");
    require(history_s > 0, "history_s", history_s, "> 0");
    require(max_climb_mps > 0, "max_climb_mps", max_climb_mps, "> 0");
}
}  // namespace rtob

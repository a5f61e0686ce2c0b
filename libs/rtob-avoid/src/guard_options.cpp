// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/avoid/guard_options.h>
#include <rtob/core/option_checks.h>

namespace rtob
{
void GuardOptions::validate() const
{
    require(guide_deg >= 0 && guide_deg <= 80, "guide_deg", guide_deg, "in [0, 80]");
    require(lookahead_m > 0, "lookahead_m", lookahead_m, "> 0");
    require(creep_speed_mps > 0, "creep_speed_mps", creep_speed_mps, "> 0");
    require(max_hole_deg >= 0 && max_hole_deg <= 45, "max_hole_deg", max_hole_deg, "in [0, 45]");
    require(max_scan_age_s > 0, "max_scan_age_s", max_scan_age_s, "> 0");
    require(lost_speed_mps > 0, "lost_speed_mps", lost_speed_mps, "> 0");
    require(memory_s >= 0, "memory_s", memory_s, ">= 0");
    require(memory_range_m > 0, "memory_range_m", memory_range_m, "> 0");
    require(
        memory_points >= 0 && memory_points <= 20000, "memory_points", memory_points,
        "in [0, 20000]");
    require(seen_tolerance_m > 0, "seen_tolerance_m", seen_tolerance_m, "> 0");
    require(pose_sigmas >= 0, "pose_sigmas", pose_sigmas, ">= 0");
}
}  // namespace rtob

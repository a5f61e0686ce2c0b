// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/avoid/vehicle_limits.h>
#include <rtob/core/option_checks.h>

namespace rtob
{
void VehicleLimits::validate() const
{
    require(radius_m > 0, "radius_m", radius_m, "> 0");
    require(margin_m >= 0, "margin_m", margin_m, ">= 0");
    require(
        max_speed_mps > 0 && max_speed_mps <= 20, "max_speed_mps", max_speed_mps,
        "> 0 and at most 20");
    require(acceleration_mps2 > 0, "acceleration_mps2", acceleration_mps2, "> 0");
    require(derating > 0 && derating <= 1, "derating", derating, "in (0, 1]");
    require(jerk_mps3 >= 0, "jerk_mps3", jerk_mps3, ">= 0");
    require(latency_s >= 0, "latency_s", latency_s, ">= 0");
    require(response_s >= 0, "response_s", response_s, ">= 0");
    require(period_s > 0, "period_s", period_s, "> 0");
}
}  // namespace rtob

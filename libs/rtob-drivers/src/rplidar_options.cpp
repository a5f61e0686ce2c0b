// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/drivers/rplidar_options.h>
#include <rtob/map/angle_mask.h>

namespace rtob
{
void RplidarOptions::validate() const
{
    require(!port.empty(), "COM_port_LIN", port, "the name of a serial port");
    require(!scan_mode.empty(), "scan_mode", scan_mode, "auto, standard, express or a mode's name");
    require(min_range_m >= 0, "min_range_m", min_range_m, ">= 0");
    require(
        max_range_m == 0 || max_range_m > min_range_m, "max_range_m", max_range_m,
        "0 or > min_range_m");
    require(beams == 0 || (beams >= 90 && beams <= 8192), "beams", beams, "0, or 90 to 8192");
    require(max_gap_deg >= 2 && max_gap_deg <= 90, "max_gap_deg", max_gap_deg, "2 to 90");
    static_cast<void>(AngleMask(mask_deg));
}
}  // namespace rtob

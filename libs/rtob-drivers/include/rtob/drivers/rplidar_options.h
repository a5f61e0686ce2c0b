// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace rtob
{
/// The keys of a sensor section with `driver = RtobRplidar`, beside those of any sensor.
struct RplidarOptions
{
    std::string port = "/dev/ttyUSB0";
    unsigned baud = 0;
    std::string scan_mode = "auto";
    unsigned motor_rpm = 0;
    bool upside_down = false;
    bool clockwise = true;
    std::string mask_deg;
    double min_range_m = 0.05;
    double max_range_m = 0;
    unsigned beams = 0;
    double max_gap_deg = 10;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("COM_port_LIN", s.port, "the serial port, e.g. /dev/rplidar with our udev rule");
        visit("COM_baudRate", s.baud, "bits per second; 0: found by trying");
        visit(
            "scan_mode", s.scan_mode,
            "auto (the device's typical one), standard, express or another name that --check "
            "shows");
        visit("motor_rpm", s.motor_rpm, "speed of S-series and later; 0: the device's own");
        visit("upside_down", s.upside_down, "the device hangs: its left is the vehicle's right");
        visit("clockwise", s.clockwise, "its bearings grow clockwise, as those of all RPLidars do");
        visit(
            "mask_deg", s.mask_deg,
            "bearings that see the vehicle itself, as the device counts them: 0 is its front, "
            "e.g. \"170..190, -10..5\"");
        visit("min_range_m", s.min_range_m, "nearer beams are invalid; >= 0");
        visit(
            "max_range_m", s.max_range_m,
            "farther beams are invalid; 0: as far as the device says it sees");
        visit("beams", s.beams, "beams of a scan; 0: as many as the device takes, or 90 to 8192");
        visit(
            "max_gap_deg", s.max_gap_deg,
            "a revolution with a wider hole is partial and dropped; 2 to 90");
    }
    void validate() const;
};
}  // namespace rtob

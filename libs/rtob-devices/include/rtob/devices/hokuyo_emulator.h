// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/emulated_device.h>
#include <rtob/devices/range_source.h>

#include <optional>
#include <string>

namespace rtob::devices
{
/// A Hokuyo UTM-30LX that speaks SCIP 2.0: 1081 beams over 270 degrees, 40 times a second. MRPT's
/// CHokuyoURG drives it over TCP.
class HokuyoEmulator : public EmulatedDevice
{
 public:
    /// @param clock_ms what its clock says at first after the power came; it begins anew at 2^24
    explicit HokuyoEmulator(RangeSource ranges, unsigned clock_ms = 0);

    void receive(const Packet& bytes, double now_s) override;
    [[nodiscard]] std::vector<Packet> send(double now_s) override;
    void restart() override;
    /// Scans come with the status of a broken motor, until the laser is switched on anew.
    void breakDown() override { has_error_ = true; }

 private:
    void answer(const std::string& command, double now_s);
    [[nodiscard]] std::string scan(double start_s) const;

    RangeSource ranges_;
    double clock_at_power_ms_;
    std::optional<double> power_s_;  ///< when it came; known from the first request on
    std::string received_;
    std::vector<Packet> replies_;
    std::string scan_command_;  ///< whose echo each scan begins with; empty: not scanning
    double next_scan_s_ = 0;
    bool has_error_ = false;
};
}  // namespace rtob::devices

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/emulated_device.h>
#include <rtob/devices/range_source.h>

#include <string>

namespace rtob::devices
{
/// A Hokuyo UTM-30LX that speaks SCIP 2.0: 1081 beams over 270 degrees, 40 times a second. MRPT's
/// CHokuyoURG drives it over TCP.
class HokuyoEmulator : public EmulatedDevice
{
 public:
    explicit HokuyoEmulator(RangeSource ranges);

    void receive(const Packet& bytes, double now_s) override;
    [[nodiscard]] std::vector<Packet> send(double now_s) override;
    void restart() override;
    /// Scans come with the status of a broken motor, until the laser is switched on anew.
    void breakDown() override { has_error_ = true; }

 private:
    void answer(const std::string& command, double now_s);
    [[nodiscard]] std::string scan(double start_s) const;

    RangeSource ranges_;
    std::string received_;
    std::vector<Packet> replies_;
    std::string scan_command_;  ///< whose echo each scan begins with; empty: not scanning
    double next_scan_s_ = 0;
    bool has_error_ = false;
};
}  // namespace rtob::devices

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/emulated_device.h>
#include <rtob/devices/range_source.h>

#include <string>

namespace rtob::devices
{
/// A SICK TiM561 that speaks CoLa A: 811 beams over 270 degrees, counter-clockwise, 15 times a
/// second. MRPT's CSICKTim561Eth drives it over TCP.
class SickEmulator : public EmulatedDevice
{
 public:
    explicit SickEmulator(RangeSource ranges);

    void receive(const Packet& bytes, double now_s) override;
    [[nodiscard]] std::vector<Packet> send(double now_s) override;
    void restart() override;
    /// It refuses to give scans, until they are switched on anew.
    void breakDown() override;

 private:
    void answer(const std::string& command, double now_s);
    void measure(double now_s);
    [[nodiscard]] std::string scanData() const;
    void reply(const std::string& telegram);

    RangeSource ranges_;
    std::string received_;
    std::vector<Packet> replies_;
    std::string ranges_text_;  ///< of the last whole scan; empty: none yet
    bool sends_each_scan_ = false, has_error_ = false;
    double next_scan_s_ = 0;
    unsigned scans_ = 0;
};
}  // namespace rtob::devices

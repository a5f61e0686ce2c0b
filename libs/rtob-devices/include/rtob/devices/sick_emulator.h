// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/emulated_device.h>
#include <rtob/devices/range_source.h>

#include <string>

namespace rtob::devices
{
/// What differs between SICK's lasers of one protocol. All see 270 degrees, counter-clockwise.
struct SickModel
{
    std::string name;
    int beams = 811;
    double step_deg = 1.0 / 3, turn_s = 1.0 / 15, max_range_m = 10;
};

/// MRPT's CSICKTim561Eth drives it over TCP.
[[nodiscard]] SickModel model_tim561();
/// 1081 beams, 25 times a second. MRPT's CLMS100Eth drives it over TCP.
[[nodiscard]] SickModel model_lms111();

/// A SICK laser that speaks CoLa A.
class SickEmulator : public EmulatedDevice
{
 public:
    explicit SickEmulator(RangeSource ranges, SickModel model = model_tim561());

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
    SickModel model_;
    std::string received_;
    std::vector<Packet> replies_;
    std::string ranges_text_;  ///< of the last whole scan; empty: none yet
    bool sends_each_scan_ = false, has_error_ = false;
    double next_scan_s_ = 0;
    unsigned scans_ = 0;
};
}  // namespace rtob::devices

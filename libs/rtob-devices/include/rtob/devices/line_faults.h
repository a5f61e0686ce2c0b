// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/emulated_device.h>
#include <rtob/devices/line_fault.h>

#include <random>
#include <vector>

namespace rtob::devices
{
/// What is wrong with a line at a moment (UNIX seconds), and what becomes of its packets.
class LineFaults
{
 public:
    /// @param duration_s of a stall and of a wrong speed, and until the device is plugged in again
    void inject(LineFault fault, EmulatedDevice& device, double now_s, double duration_s);

    [[nodiscard]] bool isUnplugged(double now_s) const { return now_s < unplugged_until_s_; }
    /// Whether requests arrive as they were sent.
    [[nodiscard]] bool isHeard(double now_s) const { return now_s >= garbled_until_s_; }
    /// What arrives of a packet.
    [[nodiscard]] Packet arriving(Packet packet, double now_s);

 private:
    void spoil(Packet& packet);

    std::vector<LineFault> waiting_;  ///< for the next packets, one each
    double silent_until_s_ = 0, garbled_until_s_ = 0, unplugged_until_s_ = 0;
    std::mt19937 random_{7};
};
}  // namespace rtob::devices

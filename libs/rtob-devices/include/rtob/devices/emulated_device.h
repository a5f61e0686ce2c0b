// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

namespace rtob::devices
{
using Packet = std::vector<std::uint8_t>;

/// A device without its line: requests in, answers and measurements out, at the times given (UNIX
/// seconds).
class EmulatedDevice
{
 public:
    EmulatedDevice() = default;
    virtual ~EmulatedDevice() = default;
    EmulatedDevice(const EmulatedDevice&) = delete;
    EmulatedDevice& operator=(const EmulatedDevice&) = delete;

    /// The host sent these bytes.
    virtual void receive(const Packet& bytes, double now_s) = 0;
    /// What the device has sent by now, each packet whole. Call it often.
    [[nodiscard]] virtual std::vector<Packet> send(double now_s) = 0;
    /// As after the power came back.
    virtual void restart() = 0;
    /// It is broken, and says so as its protocol does, until it is set up anew.
    virtual void breakDown() = 0;
};
}  // namespace rtob::devices

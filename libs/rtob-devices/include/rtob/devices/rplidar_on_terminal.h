// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/line_fault.h>
#include <rtob/devices/pseudo_terminal.h>
#include <rtob/devices/rplidar_emulator.h>

#include <atomic>
#include <mutex>
#include <random>
#include <thread>

namespace rtob::devices
{
/// An emulated RPLidar on a pseudo-terminal, alive in a thread of its own. At another speed than
/// its own it hears nothing.
class RplidarOnTerminal
{
 public:
    RplidarOnTerminal(const std::string& link, RplidarModel model, RangeSource ranges);
    ~RplidarOnTerminal();
    RplidarOnTerminal(const RplidarOnTerminal&) = delete;
    RplidarOnTerminal& operator=(const RplidarOnTerminal&) = delete;

    /// Lets this happen to what is sent next.
    /// @param duration_s of a stall, or until the device is plugged in again
    void inject(LineFault fault, double duration_s = 0.5);

    [[nodiscard]] const std::string& port() const { return terminal_.name(); }
    [[nodiscard]] bool isScanning() const { return is_scanning_; }
    /// Since when the running scan goes on (UNIX seconds).
    [[nodiscard]] double shaftDeg(double time_s) const;

 private:
    void live();
    void step();
    void spoil(std::vector<std::uint8_t>& bytes);

    PseudoTerminal terminal_;
    mutable std::mutex mutex_;  ///< guards the emulator and the faults
    RplidarEmulator emulator_;
    std::vector<LineFault> waiting_;  ///< faults of bytes, for the next ones
    double silent_until_s_ = 0, unplugged_until_s_ = 0;
    std::mt19937 random_{7};
    std::atomic<bool> is_scanning_{false};
    std::atomic<bool> ends_{false};
    std::thread thread_;
};
}  // namespace rtob::devices

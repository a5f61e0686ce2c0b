// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/line_faults.h>
#include <rtob/devices/pseudo_terminal.h>
#include <rtob/devices/rplidar_emulator.h>

#include <atomic>
#include <mutex>
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

    /// @param duration_s of a stall and of a wrong speed, and until the device is plugged in again
    void inject(LineFault fault, double duration_s = 0.5);

    [[nodiscard]] const std::string& port() const { return terminal_.name(); }
    [[nodiscard]] bool isScanning() const { return is_scanning_; }
    /// Since when the running scan goes on (UNIX seconds).
    [[nodiscard]] double shaftDeg(double time_s) const;

 private:
    void live();
    void step();

    PseudoTerminal terminal_;
    mutable std::mutex mutex_;  ///< guards the emulator and the faults
    RplidarEmulator emulator_;
    LineFaults faults_;
    std::atomic<bool> is_scanning_{false};
    std::atomic<bool> ends_{false};
    std::thread thread_;
};
}  // namespace rtob::devices

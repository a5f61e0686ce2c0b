// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/line_faults.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

namespace rtob::devices
{
/// An emulated device at a TCP port of the loopback address, alive in a thread of its own, for one
/// client at a time.
class DeviceOnTcp
{
 public:
    /// @param port 0: any that is free
    /// Throws std::runtime_error where the port cannot be had.
    explicit DeviceOnTcp(std::unique_ptr<EmulatedDevice> device, int port = 0);
    ~DeviceOnTcp();
    DeviceOnTcp(const DeviceOnTcp&) = delete;
    DeviceOnTcp& operator=(const DeviceOnTcp&) = delete;

    [[nodiscard]] int port() const { return port_; }
    /// @param duration_s of a stall and of a wrong speed, and until the device is plugged in again
    void inject(LineFault fault, double duration_s = 0.5);

 private:
    void live();
    void step();
    void listenAtPort();
    void accept();
    void receive();
    void hangUp();
    void unplug();

    std::unique_ptr<EmulatedDevice> device_;
    LineFaults faults_;
    std::mutex mutex_;  ///< guards the device and the faults
    int listener_ = -1, client_ = -1, port_ = 0;
    std::atomic<bool> ends_{false};
    std::thread thread_;
};
}  // namespace rtob::devices

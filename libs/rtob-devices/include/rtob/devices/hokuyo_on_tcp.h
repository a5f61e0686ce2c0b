// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/range_source.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

namespace rtob::devices
{
/// An emulated Hokuyo UTM-30LX: 1081 beams over 270 degrees, 40 times a second, in SCIP 2.0 over
/// TCP at the loopback address, for one client at a time; MRPT's CHokuyoURG drives it.
class HokuyoOnTcp
{
 public:
    /// Throws std::runtime_error where no port can be had.
    explicit HokuyoOnTcp(RangeSource ranges);
    ~HokuyoOnTcp();
    HokuyoOnTcp(const HokuyoOnTcp&) = delete;
    HokuyoOnTcp& operator=(const HokuyoOnTcp&) = delete;

    [[nodiscard]] int port() const { return port_; }
    /// Sends nothing until then (UNIX seconds).
    void stallUntil(double time_s) { silent_until_s_ = time_s; }
    /// Ends the connection, as a pulled cable does.
    void disconnect() { disconnects_ = true; }

 private:
    void live();
    void serve(int client);
    void answer(int client, const std::string& command);
    void sendScan(int client, double start_s);

    RangeSource ranges_;
    int listener_ = -1, port_ = 0;
    std::string scan_command_;  ///< whose echo each scan begins with; empty: not scanning
    double next_scan_s_ = 0;
    std::atomic<double> silent_until_s_{0};
    std::atomic<bool> disconnects_{false}, ends_{false};
    std::thread thread_;
};
}  // namespace rtob::devices

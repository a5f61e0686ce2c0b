// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace rtob
{
/// What `rtob-slam emulate` is asked for.
struct EmulateJob
{
    std::string device;  ///< one of emulated_devices()
    std::string log;     ///< whose scans the device sees
    std::string port;    ///< a file name of a serial device, a number of a TCP device; empty: usual
    double faults_every_s = 0;  ///< 0: none
    double seconds = 0;         ///< 0: until it is stopped
};

[[nodiscard]] std::vector<std::string> emulated_devices();

/// Plays the log, again and again, to whoever drives the device. Throws std::runtime_error.
void emulate(const EmulateJob& job, std::ostream& out, const std::function<bool()>& stop);
}  // namespace rtob

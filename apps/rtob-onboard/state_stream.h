// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/slam/scan_report.h>

#include <string>
#include <vector>

#include "onboard_options.h"

namespace rtob
{
/// What others hear with each scan.
struct LiveState
{
    const ScanReport& report;
    double latency_s = 0;  ///< from the scan's last beam to its pose
    std::uint64_t scans = 0, dropped = 0;
};

/// One line of JSON, with its end of line.
[[nodiscard]] std::string state_line(const LiveState& state);

/// Sends lines to whom it may concern. Never waits: who does not read is dropped.
class StateStream
{
 public:
    /// Throws std::runtime_error where an address cannot be used.
    explicit StateStream(const StateStreamOptions& options);
    ~StateStream();
    StateStream(const StateStream&) = delete;
    StateStream& operator=(const StateStream&) = delete;

    void publish(const std::string& line);

 private:
    void acceptClients();

    int udp_ = -1, tcp_ = -1;
    std::vector<int> clients_;
};
}  // namespace rtob

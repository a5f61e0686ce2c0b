// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <deque>

namespace rtob
{
/// When a device sent its packets, from when they arrived. It sends at a steady rate: what a busy
/// computer reads late was not sent late. So the least late of the last packets tells the time.
class SteadyStamps
{
 public:
    /// @param period_s between two packets; 0: not known, and times pass as they are
    explicit SteadyStamps(double period_s = 0) : period_s_(period_s) {}

    /// Of the next packet; never before the last one.
    [[nodiscard]] double sent(double arrival_s);

    /// Packets were lost: when the next one is due is not known.
    void forget() { earliest_.clear(); }

 private:
    struct Arrival
    {
        std::uint64_t packet;
        double late_s;  ///< against a device that sent its packet 0 at 0
    };
    double period_s_;
    std::uint64_t packet_ = 0;
    double last_s_ = 0;
    std::deque<Arrival> earliest_;  ///< each less late than those after it
};
}  // namespace rtob

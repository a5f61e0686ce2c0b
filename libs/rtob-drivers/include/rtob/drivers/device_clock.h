// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <deque>

namespace rtob
{
/// A device's own clock, read on the computer's. What the device sent arrives later, never
/// earlier: so the least late of the last packets tells by how much the two clocks differ. It
/// follows a clock that runs a little slow or fast, or was set.
class DeviceClock
{
 public:
    /// @param memory_s of the device: the last packets are those not older than that
    /// @param longest_delay_s a packet that is later than the last ones by more than that was not
    /// delayed: the device was silent
    DeviceClock(double memory_s, double longest_delay_s)
        : memory_s_(memory_s), longest_delay_s_(longest_delay_s)
    {
    }

    /// When the packet was sent, on the computer's clock: never after it arrived, never before the
    /// last one.
    [[nodiscard]] double sent(double device_s, double arrival_s);

    /// How the clocks differ is not known any more.
    void forget() { earliest_.clear(); }

 private:
    struct Arrival
    {
        double device_s;
        double late_s;  ///< computer's clock less device's clock: their difference, and the delay
    };
    double memory_s_, longest_delay_s_;
    double last_s_ = 0;
    std::deque<Arrival> earliest_;  ///< each less late than those after it
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/device_clock.h>

#include <cstdint>

namespace rtob
{
/// When a device without a clock sent its packets, from when they arrived: it sends at a steady
/// rate, and so its packets are its clock.
class SteadyStamps
{
 public:
    /// @param period_s between two packets; 0: not known, and times pass as they are
    explicit SteadyStamps(double period_s = 0);

    /// Of the next packet; never before the last one.
    [[nodiscard]] double sent(double arrival_s);

    /// Packets were lost: when the next one is due is not known.
    void forget() { clock_.forget(); }

 private:
    double period_s_;
    std::uint64_t packet_ = 0;
    DeviceClock clock_;
};
}  // namespace rtob

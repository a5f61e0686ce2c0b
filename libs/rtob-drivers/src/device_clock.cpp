// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/device_clock.h>

#include <algorithm>

namespace rtob
{
double DeviceClock::sent(double device_s, double arrival_s)
{
    const double late_s = arrival_s - device_s;
    if (!earliest_.empty())
    {
        const bool was_set_back = device_s < earliest_.back().device_s;
        const bool was_silent = late_s - earliest_.front().late_s > longest_delay_s_;
        if (was_set_back || was_silent) forget();
    }
    while (!earliest_.empty() && earliest_.back().late_s >= late_s) earliest_.pop_back();
    earliest_.push_back({device_s, late_s});
    while (device_s - earliest_.front().device_s > memory_s_) earliest_.pop_front();
    return last_s_ = std::max(last_s_, device_s + earliest_.front().late_s);
}
}  // namespace rtob

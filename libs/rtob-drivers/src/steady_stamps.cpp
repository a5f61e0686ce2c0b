// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/steady_stamps.h>

#include <algorithm>

namespace rtob
{
namespace
{
/// A device whose true period is a hundredth longer than it says is then believed 5 ms early.
constexpr double kMemory_s = 0.5;
/// No computer is that busy: the device was silent, though it lost nothing.
constexpr double kLongestDelay_s = 1;
}  // namespace

double SteadyStamps::sent(double arrival_s)
{
    if (period_s_ <= 0) return arrival_s;
    const double due_s = static_cast<double>(packet_) * period_s_;
    const double late_s = arrival_s - due_s;
    if (!earliest_.empty() && late_s - earliest_.front().late_s > kLongestDelay_s) forget();
    while (!earliest_.empty() && earliest_.back().late_s >= late_s) earliest_.pop_back();
    earliest_.push_back({packet_, late_s});
    while (static_cast<double>(packet_ - earliest_.front().packet) * period_s_ > kMemory_s)
        earliest_.pop_front();
    ++packet_;
    return last_s_ = std::max(last_s_, due_s + earliest_.front().late_s);
}
}  // namespace rtob

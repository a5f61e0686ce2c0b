// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/steady_stamps.h>

namespace rtob
{
namespace
{
/// A device whose true period is a hundredth longer than it says is then believed 5 ms early.
constexpr double kMemory_s = 0.5;
/// No computer is that busy: the device was silent, though it lost nothing.
constexpr double kLongestDelay_s = 1;
}  // namespace

SteadyStamps::SteadyStamps(double period_s)
    : period_s_(period_s), clock_(kMemory_s, kLongestDelay_s)
{
}

double SteadyStamps::sent(double arrival_s)
{
    if (period_s_ <= 0) return arrival_s;
    return clock_.sent(static_cast<double>(packet_++) * period_s_, arrival_s);
}
}  // namespace rtob

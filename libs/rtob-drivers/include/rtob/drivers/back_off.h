// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <chrono>

namespace rtob
{
/// When to try again what failed: soon, then less and less often.
class BackOff
{
 public:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool mayTry(Clock::time_point now) const { return now >= next_; }

    void failed(Clock::time_point now)
    {
        next_ = now + pause_;
        pause_ = std::min(2 * pause_, kLongest);
    }
    void succeeded()
    {
        pause_ = kShortest;
        next_ = {};
    }
    [[nodiscard]] Clock::duration untilNext(Clock::time_point now) const
    {
        return std::max(Clock::duration::zero(), next_ - now);
    }

 private:
    static constexpr std::chrono::milliseconds kShortest{200}, kLongest{3200};

    std::chrono::milliseconds pause_ = kShortest;
    Clock::time_point next_{};
};
}  // namespace rtob

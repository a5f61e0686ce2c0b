// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/core/Clock.h>

namespace rtob
{
/// Now, in the seconds that stamps of logs are in: those of MRPT's clock, which its drivers use,
/// too.
[[nodiscard]] inline double unix_time_s()
{
    return mrpt::Clock::nowDouble();
}

/// From now on that clock goes on evenly, whatever the computer's clock is set to. To be called
/// before there are other threads.
inline void keep_time_from_now_on()
{
    mrpt::Clock::setActiveClock(mrpt::Clock::Source::Monotonic);
    static_cast<void>(mrpt::Clock::now());  // notes by how much the two differ
}
}  // namespace rtob

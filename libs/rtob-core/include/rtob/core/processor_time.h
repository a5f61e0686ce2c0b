// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ctime>

namespace rtob
{
/// What a POSIX clock shows [s].
[[nodiscard]] inline double clock_time_s(clockid_t clock)
{
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The processor's time [s] that this thread has used: unlike a clock, it does not tell how busy
/// the machine is with others.
[[nodiscard]] inline double thread_processor_time_s()
{
    return clock_time_s(CLOCK_THREAD_CPUTIME_ID);
}

/// The same of all threads: what the program takes from others on this computer.
[[nodiscard]] inline double process_processor_time_s()
{
    return clock_time_s(CLOCK_PROCESS_CPUTIME_ID);
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ctime>

namespace rtob
{
/// The processor's time [s] that this thread has used: unlike a clock, it does not tell how busy
/// the machine is with others.
[[nodiscard]] inline double thread_processor_time_s()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
// Preloaded into a program, as LD_PRELOAD: the computer's clock is set back by an hour as soon as
// the file is there that RTOB_CLOCK_STEPS_WITH names.
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cstdlib>

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept
{
    const long result = syscall(SYS_clock_gettime, clock, time);
    const char* file = std::getenv("RTOB_CLOCK_STEPS_WITH");
    if (result == 0 && clock == CLOCK_REALTIME && file != nullptr && access(file, F_OK) == 0)
        time->tv_sec -= 3600;
    return static_cast<int>(result);
}

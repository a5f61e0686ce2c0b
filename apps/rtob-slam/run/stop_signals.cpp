// SPDX-License-Identifier: BSD-3-Clause
#include "run/stop_signals.h"

#include <ctime>

namespace rtob
{
namespace
{
volatile std::sig_atomic_t stop_requested = 0;
volatile std::sig_atomic_t requested_at_s = 0;

/// Calls only what a signal handler may call.
std::sig_atomic_t seconds_now()
{
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::sig_atomic_t>(now.tv_sec);
}

/// timeout(1) and some shells send the same signal twice at once: that is one wish.
void request_stop(int signal)
{
    constexpr std::sig_atomic_t one_wish_s = 1;
    if (stop_requested == 0)
    {
        requested_at_s = seconds_now();
        stop_requested = 1;
    }
    else if (seconds_now() - requested_at_s > one_wish_s)
    {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}
}  // namespace

StopSignals::StopSignals()
{
    stop_requested = 0;
    struct sigaction action = {};
    action.sa_handler = request_stop;
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, &old_int_);
    sigaction(SIGTERM, &action, &old_term_);
}

StopSignals::~StopSignals()
{
    sigaction(SIGINT, &old_int_, nullptr);
    sigaction(SIGTERM, &old_term_, nullptr);
}

bool StopSignals::requested()
{
    return stop_requested != 0;
}
}  // namespace rtob

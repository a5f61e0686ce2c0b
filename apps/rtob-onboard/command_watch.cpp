// SPDX-License-Identifier: BSD-3-Clause
#include "command_watch.h"

#include <cmath>

#include "guard_messages.h"

namespace rtob
{
void CommandWatch::put(GuardCommand command, double now_s)
{
    const std::lock_guard lock(mutex_);
    command_ = std::move(command);
    decided_s_ = now_s;
    is_stalled_ = false;
}

GuardCommand CommandWatch::take(double now_s)
{
    const std::lock_guard lock(mutex_);
    if (std::abs(now_s - decided_s_) <= max_stall_s_) return command_;
    stalls_ += is_stalled_ ? 0 : 1;
    is_stalled_ = true;
    GuardCommand stop;
    stop.target = velocity_target({0, 0}, 0, 0, now_s);
    stop.state = "STALLED";
    return stop;
}

std::uint64_t CommandWatch::stalls() const
{
    const std::lock_guard lock(mutex_);
    return stalls_;
}
}  // namespace rtob

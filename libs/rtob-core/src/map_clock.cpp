// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/map_clock.h>
#include <cmath>

namespace rtob
{
double MapClock::advance(double stamp_s)
{
    if (!std::isfinite(stamp_s))
    {
        ++state_.anomalies.invalid;
        return state_.now_s;
    }
    double step_s = state_.started ? stamp_s - state_.last_stamp_s : 0.0;
    if (state_.started && step_s < 0) ++state_.anomalies.steps_back;
    if (state_.started && step_s == 0) ++state_.anomalies.repeats;
    if (step_s < 0) step_s = 0;
    if (step_s > max_step_s_)
    {
        ++state_.anomalies.jumps;
        step_s = max_step_s_;
    }
    state_.started = true;
    state_.last_stamp_s = stamp_s;
    return state_.now_s += step_s;
}
}  // namespace rtob

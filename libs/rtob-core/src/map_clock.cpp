// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/map_clock.h>
#include <cmath>

namespace rtob
{
double MapClock::advance(double stamp_s)
{
    if (!std::isfinite(stamp_s))
    {
        ++anomalies_.invalid;
        return now_s_;
    }
    double step_s = started_ ? stamp_s - last_stamp_s_ : 0.0;
    if (started_ && step_s < 0) ++anomalies_.steps_back;
    if (started_ && step_s == 0) ++anomalies_.repeats;
    if (step_s < 0) step_s = 0;
    if (step_s > max_step_s_)
    {
        ++anomalies_.jumps;
        step_s = max_step_s_;
    }
    started_ = true;
    last_stamp_s_ = stamp_s;
    return now_s_ += step_s;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "run/progress_line.h"

#include <rtob/core/enum_names.h>

#include <cstdio>

namespace rtob
{
std::string progress_text(const Progress& progress)
{
    char text[96];
    const double speed = progress.run_time_s > 0 ? progress.log_time_s / progress.run_time_s : 0;
    std::snprintf(
        text, sizeof text, "%3.0f %%  %llu scans  %.0fx real time  ", 100 * progress.log_share,
        static_cast<unsigned long long>(progress.scans), speed);
    return text + std::string(name_of(progress.state));
}

void ProgressLine::update(const Progress& progress, Clock::time_point now)
{
    constexpr auto interval = std::chrono::milliseconds(200);
    if (!enabled_ || now < next_) return;
    next_ = now + interval;
    shown_ = true;
    out_ << "\r\033[K" << progress_text(progress) << std::flush;
}

void ProgressLine::clear()
{
    if (!shown_) return;
    out_ << "\r\033[K" << std::flush;
    shown_ = false;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/slam/tracking.h>

#include <chrono>
#include <cstdint>
#include <ostream>
#include <string>

namespace rtob
{
struct Progress
{
    double log_share = 0;  ///< of the log, [0, 1]
    std::uint64_t scans = 0;
    double log_time_s = 0;  ///< how much of the drive has passed
    double run_time_s = 0;  ///< how long that took
    TrackingState state = TrackingState::Init;
};

/// "37 %  5043 scans  212x real time  TRACKING"
[[nodiscard]] std::string progress_text(const Progress& progress);

/// A line on a terminal that is drawn over itself a few times a second.
class ProgressLine
{
 public:
    using Clock = std::chrono::steady_clock;

    ProgressLine(std::ostream& out, bool enabled) : out_(out), enabled_(enabled) {}
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Draws when a fifth of a second has passed since the last time.
    void update(const Progress& progress, Clock::time_point now);
    void clear();

 private:
    std::ostream& out_;
    bool enabled_;
    bool shown_ = false;
    Clock::time_point next_{};
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

namespace rtob
{
/// Turns a log's stamps into the map's time axis. The order of arrival is the truth: real logs step
/// back, repeat and jump, so map time starts at 0, never runs back, and grows by the step between
/// two stamps, cut to [0, max_step_s].
class MapClock
{
 public:
    struct Anomalies
    {
        std::uint64_t steps_back = 0, repeats = 0, jumps = 0, invalid = 0;
    };

    explicit MapClock(double max_step_s = 10.0) : max_step_s_(max_step_s) {}

    /// Map time of the scan with this stamp [s]; a stamp that is no number stands still.
    double advance(double stamp_s);

    [[nodiscard]] double now() const { return now_s_; }
    [[nodiscard]] const Anomalies& anomalies() const { return anomalies_; }

 private:
    double max_step_s_;
    double now_s_ = 0;
    double last_stamp_s_ = 0;
    bool started_ = false;
    Anomalies anomalies_;
};
}  // namespace rtob

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

    /// Where the clock stands: what a stored map needs, so that its time goes on as before.
    struct State
    {
        double now_s = 0, last_stamp_s = 0;
        bool started = false;
        Anomalies anomalies;
    };

    explicit MapClock(double max_step_s = 10.0) : max_step_s_(max_step_s) {}

    [[nodiscard]] const State& state() const { return state_; }
    void restore(const State& state) { state_ = state; }

    /// Map time of the scan with this stamp [s]; a stamp that is no number stands still.
    double advance(double stamp_s);

    [[nodiscard]] double now() const { return state_.now_s; }
    [[nodiscard]] const Anomalies& anomalies() const { return state_.anomalies; }

 private:
    double max_step_s_;
    State state_;
};
}  // namespace rtob

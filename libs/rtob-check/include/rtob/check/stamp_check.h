// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/check/check_report.h>

#include <cstdint>
#include <vector>

namespace rtob
{
/// The stamps of one sensor in order of arrival: order, repeats, gaps, jumps, rate and jitter.
class StampCheck
{
 public:
    /// @param stamp_s no number where the log has no stamp
    void add(double stamp_s);
    void report(CheckReport& report) const;

    /// On average, pauses of the recording left out, s; 0: unknown.
    [[nodiscard]] double usualInterval() const;

 private:
    [[nodiscard]] double intervalAt(double share) const;
    [[nodiscard]] std::uint64_t intervalsAbove(double interval_s) const;
    void reportOrder(CheckReport& report) const;
    void reportRate(CheckReport& report) const;
    void reportGaps(CheckReport& report) const;

    std::uint64_t stamps_ = 0, invalid_ = 0, repeats_ = 0, steps_back_ = 0, jumps_ = 0;
    double last_s_ = 0, worst_back_s_ = 0, largest_gap_s_ = 0, largest_gap_at_s_ = 0;
    double largest_jump_s_ = 0;
    double elapsed_s_ = 0;  ///< without the jumps
    bool started_ = false;
    std::uint64_t forward_ = 0;             ///< intervals in the histogram
    std::vector<std::uint64_t> intervals_;  ///< counts; each bin is 1 % wider than the one before
};
}  // namespace rtob

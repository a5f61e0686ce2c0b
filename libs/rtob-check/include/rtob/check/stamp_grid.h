// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/check/check_report.h>

#include <optional>
#include <vector>

namespace rtob
{
/// Whether a sensor's stamps were computed from its rate: measured ones never keep to an interval
/// to the microsecond.
class StampGrid
{
 public:
    /// @param stamp_s no number where the log has no stamp
    void add(double stamp_s);
    /// Says nothing of fewer than 100 intervals.
    void report(CheckReport& report) const;

 private:
    std::optional<double> last_s_;
    std::vector<double> intervals_s_;  ///< the first 200 000
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/check/check_report.h>
#include <rtob/check/range_histogram.h>

#include <cstdint>
#include <optional>

namespace rtob
{
/// The values of the ranges: what stands for "no return", error codes, reach, share of no returns.
class RangeCheck
{
 public:
    void add(const mrpt::obs::CObservation2DRangeScan& scan);
    void report(CheckReport& report) const;

    [[nodiscard]] std::optional<Sentinel> farSentinel() const;
    /// Every range from here on means "no return"; what run's default keeps where there is none.
    [[nodiscard]] double usefulRange() const;

 private:
    void reportFar(CheckReport& report) const;
    void reportZero(CheckReport& report) const;
    void reportCodes(CheckReport& report) const;
    void reportShare(CheckReport& report) const;
    void reportReach(CheckReport& report) const;

    RangeHistogram histogram_;
    std::uint64_t beams_ = 0, not_a_number_ = 0, zero_ = 0, negative_ = 0, beyond_ = 0;
    std::uint64_t zero_valid_ = 0, codes_ = 0, codes_valid_ = 0, invalid_ = 0;
    double smallest_code_m_ = 0, largest_code_m_ = 0;
};
}  // namespace rtob

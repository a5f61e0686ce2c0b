// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/check/check_report.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace rtob
{
/// A value, or a narrow band of values, that stands for "no return".
struct Sentinel
{
    double low_m = 0, high_m = 0;        ///< the band
    double usual_m = 0;                  ///< its most frequent value, to the centimetre
    std::uint64_t count = 0, valid = 0;  ///< beams with it, and those that the log calls valid
    double reach_m = 0;                  ///< the farthest range below the band
};

/// The values of the ranges: what stands for "no return", error codes, reach, share of no returns.
class RangeCheck
{
 public:
    RangeCheck();
    void add(const mrpt::obs::CObservation2DRangeScan& scan);
    void report(CheckReport& report) const;

    /// At the far end of the values. Not a wall: it is seen in many directions, and there is next
    /// to nothing for metres below it.
    [[nodiscard]] std::optional<Sentinel> farSentinel() const;
    /// Every range from here on means "no return"; what run's default keeps where there is none.
    [[nodiscard]] double usefulRange() const;

 private:
    /// A centimetre of range.
    struct Bin
    {
        std::uint64_t count = 0, valid = 0;
        std::uint64_t directions = 0;  ///< a bit for each 64th of the field
    };
    [[nodiscard]] Bin sum(std::size_t begin, std::size_t end) const;
    [[nodiscard]] std::optional<std::size_t> lastUsedBelow(std::size_t end) const;
    [[nodiscard]] double rangeAt(double share, double limit_m) const;
    void reportFar(CheckReport& report) const;
    void reportZero(CheckReport& report) const;
    void reportCodes(CheckReport& report) const;
    void reportShare(CheckReport& report) const;
    void reportReach(CheckReport& report) const;

    std::vector<Bin> bins_;
    std::uint64_t beams_ = 0, not_a_number_ = 0, zero_ = 0, negative_ = 0, beyond_ = 0;
    std::uint64_t zero_valid_ = 0, codes_ = 0, codes_valid_ = 0, invalid_ = 0;
    double smallest_code_m_ = 0, largest_code_m_ = 0;
};
}  // namespace rtob

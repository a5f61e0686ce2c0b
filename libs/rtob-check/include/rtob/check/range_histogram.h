// SPDX-License-Identifier: BSD-3-Clause
#pragma once
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

/// How often each centimetre of range occurs, and in which directions.
class RangeHistogram
{
 public:
    static constexpr double kEnd_m = 655;  ///< farther ranges have no place

    RangeHistogram();
    /// @param range_m above 0 and below kEnd_m
    /// @param direction 0 to 63: a 64th of the laser's field
    void add(float range_m, bool valid, unsigned direction);

    /// At the far end of the values. Not a wall: it is seen in many directions, and there is next
    /// to nothing for metres below it.
    /// @param beams in all, also those that are not in the histogram
    [[nodiscard]] std::optional<Sentinel> farSentinel(std::uint64_t beams) const;

    /// This share of the ranges below the limit is smaller; 0 where there are none.
    [[nodiscard]] double quantile(double share, double limit_m) const;

 private:
    struct Bin
    {
        std::uint64_t count = 0, valid = 0;
        std::uint64_t directions = 0;  ///< a bit each
    };
    [[nodiscard]] Bin sum(std::size_t begin, std::size_t end) const;
    [[nodiscard]] std::optional<std::size_t> lastUsedBelow(std::size_t end) const;
    [[nodiscard]] std::optional<Sentinel> sentinelIn(std::size_t begin, std::size_t end) const;

    std::vector<Bin> bins_;
};
}  // namespace rtob

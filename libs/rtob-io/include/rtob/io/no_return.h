// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace rtob
{
/// The range that a laser reports where nothing came back.
struct NoReturn
{
    float from_m = 0;  ///< ranges of this and more mean it
    std::uint64_t beams = 0;
};

/// Finds the "no return" of a laser whose log does not tell it: the large number that stands in for
/// it differs from scanner to scanner (51.1, 81.83, 81.91 m).
class NoReturnFinder
{
 public:
    void add(const mrpt::obs::CObservation2DRangeScan& scan);

    /// A number stands in for "no return" if it is the farthest of all, comes often, at many of the
    /// beams, and leaves a gap of hardly any range below it. A far wall fails that: it is seen by
    /// few beams, and from elsewhere at another range.
    [[nodiscard]] std::optional<NoReturn> found() const;

 private:
    [[nodiscard]] std::uint64_t between(int first_bin, int end_bin) const;

    struct Bin
    {
        std::uint64_t count = 0;
        float nearest_m = 0;
        std::vector<bool> seen_by_beam;
    };
    std::map<int, Bin> bins_;  ///< by range in units of bin_m
    std::uint64_t beams_ = 0;
};

/// Whether the log does not tell which ranges of this scan are no returns.
[[nodiscard]] bool lacks_max_range(const mrpt::obs::CObservation2DRangeScan& scan);

/// The scan with its maximum range, and with the beams from there on marked invalid. Ranges stay.
[[nodiscard]] mrpt::obs::CObservation2DRangeScan::Ptr with_max_range(
    const mrpt::obs::CObservation2DRangeScan& scan, float max_range_m);
}  // namespace rtob

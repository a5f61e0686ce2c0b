// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtob
{
/// Consecutive scans [first, end).
struct ScanRange
{
    std::size_t first = 0, end = 0;
};

/// The scans of a map in order of arrival: when and where each was taken and which points are its
/// own. The points themselves lie with the map, in the same order, so a scan's points are
/// [firstPoint(k), firstPoint(k + 1)).
class ScanTable
{
 public:
    /// @param time_s map time, not before the last scan's. @throws std::invalid_argument if it is.
    void append(double time_s, const Pose2& pose_map_vehicle, std::uint32_t point_count);
    void move(std::size_t scan, const Pose2& pose_map_vehicle);
    void clear();
    void reserve(std::size_t scans, std::size_t points);
    /// Forgets all other scans; those that stay move up. Allocates nothing.
    /// @param keep one entry a scan: 0 to forget it.
    void keepOnly(const std::vector<char>& keep);

    [[nodiscard]] std::size_t size() const { return time_s_.size(); }
    [[nodiscard]] bool empty() const { return time_s_.empty(); }
    [[nodiscard]] std::uint64_t pointCount() const { return first_point_.back(); }
    [[nodiscard]] std::uint64_t firstPoint(std::size_t scan) const { return first_point_[scan]; }
    [[nodiscard]] double time(std::size_t scan) const { return time_s_[scan]; }
    [[nodiscard]] double x(std::size_t scan) const { return x_[scan]; }
    [[nodiscard]] double y(std::size_t scan) const { return y_[scan]; }
    [[nodiscard]] const double* times() const { return time_s_.data(); }
    [[nodiscard]] const double* xs() const { return x_.data(); }
    [[nodiscard]] const double* ys() const { return y_.data(); }
    [[nodiscard]] Pose2 pose(std::size_t scan) const { return {x_[scan], y_[scan], yaw_[scan]}; }

    /// The scan that the point belongs to; point < pointCount(). A look-up and a few steps: scans
    /// of fewer points than a page take up to a page of steps.
    [[nodiscard]] std::size_t scanOf(std::uint64_t point) const
    {
        std::size_t scan = scan_of_page_[static_cast<std::size_t>(point >> kPageBits)];
        while (first_point_[scan + 1] <= point) ++scan;
        return scan;
    }

    /// Say early what will be looked at, so that memory brings it while something else is done:
    /// scanOf() of a point, and a scan with those around it.
    void expectScanOf(std::uint64_t point) const
    {
        __builtin_prefetch(scan_of_page_.data() + (point >> kPageBits));
    }
    void expectAround(std::size_t scan) const
    {
        constexpr std::size_t kBefore = 40, kLine = 8;  // scans; one memory line holds 8
        const std::size_t first = scan > kBefore ? scan - kBefore : 0;
        for (const auto* column : {&time_s_, &x_, &y_})
            for (std::size_t k = first; k < first + 2 * kBefore; k += 2 * kLine)
                __builtin_prefetch(column->data() + k);
        __builtin_prefetch(first_point_.data() + scan);
    }

    /// The first scan at or after this time; size() when there is none.
    [[nodiscard]] std::size_t firstScanSince(double time_s) const;

    /// The first scan of `from`..0 that is not older than time_s, searched backwards in growing
    /// steps: the cost follows the distance, not the map.
    [[nodiscard]] std::size_t backTo(double time_s, std::size_t from) const;
    /// One past the last scan of `from`..size() that is not newer than time_s, searched forwards.
    [[nodiscard]] std::size_t forwardTo(double time_s, std::size_t from) const;

    /// The most scans ever taken within one second, both ends included: bounds every local rate.
    [[nodiscard]] std::size_t densestSecond() const { return densest_second_; }

    /// Bytes in use (not reserved).
    [[nodiscard]] std::size_t bytes() const;

 private:
    static constexpr unsigned kPageBits = 6;  // 64 points a page: 1/16 byte a point

    std::vector<double> time_s_, x_, y_, yaw_;
    std::vector<std::uint64_t> first_point_{0};  ///< one more than scans: the last is the total
    std::vector<std::uint32_t> scan_of_page_;    ///< the scan that holds the page's first point
    std::size_t densest_second_ = 0;
    std::size_t second_begin_ = 0;  ///< first scan of the newest second
};
}  // namespace rtob

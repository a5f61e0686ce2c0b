// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/large_pages.h>
#include <rtob/core/scan_table.h>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace rtob
{
void ScanTable::append(double time_s, const Pose2& pose_map_vehicle, std::uint32_t point_count)
{
    const double oldest_s = empty() ? -std::numeric_limits<double>::max() : time_s_.back();
    if (!(time_s >= oldest_s))  // also when it is no number
        throw std::invalid_argument(
            "ScanTable::append: time " + std::to_string(time_s) + " s is not at or after " +
            std::to_string(oldest_s) + " s, the last scan's; take map time from MapClock");
    const auto scan = static_cast<std::uint32_t>(size());
    time_s_.push_back(time_s);
    x_.push_back(pose_map_vehicle.x);
    y_.push_back(pose_map_vehicle.y);
    yaw_.push_back(pose_map_vehicle.yaw);
    const std::uint64_t end = first_point_.back() + point_count;
    while ((static_cast<std::uint64_t>(scan_of_page_.size()) << kPageBits) < end)
        scan_of_page_.push_back(scan);
    first_point_.push_back(end);

    while (time_s_[second_begin_] < time_s - 1.0) ++second_begin_;
    densest_second_ = std::max(densest_second_, size() - second_begin_);
}

void ScanTable::move(std::size_t scan, const Pose2& pose_map_vehicle)
{
    x_[scan] = pose_map_vehicle.x;
    y_[scan] = pose_map_vehicle.y;
    yaw_[scan] = pose_map_vehicle.yaw;
}

void ScanTable::keepOnly(const std::vector<char>& keep)
{
    std::size_t kept = 0, kept_before_second = 0;
    scan_of_page_.clear();
    std::uint64_t begin = 0;  // of the scan, before it moves
    for (std::size_t scan = 0; scan < keep.size(); ++scan)
    {
        const std::uint64_t end = first_point_[scan + 1], points = end - begin;
        begin = end;
        if (scan == second_begin_) kept_before_second = kept;
        if (keep[scan] == 0) continue;
        for (auto* column : {&time_s_, &x_, &y_, &yaw_}) (*column)[kept] = (*column)[scan];
        const std::uint64_t end_now = first_point_[kept] + points;
        while ((static_cast<std::uint64_t>(scan_of_page_.size()) << kPageBits) < end_now)
            scan_of_page_.push_back(static_cast<std::uint32_t>(kept));
        first_point_[++kept] = end_now;
    }
    for (auto* column : {&time_s_, &x_, &y_, &yaw_}) column->resize(kept);
    first_point_.resize(kept + 1);
    second_begin_ = kept_before_second;
}

void ScanTable::clear()
{
    *this = ScanTable();
}

void ScanTable::reserve(std::size_t scans, std::size_t points)
{
    for (auto* v : {&time_s_, &x_, &y_, &yaw_})
    {
        v->reserve(scans);
        prefer_large_pages(v->data(), v->capacity() * sizeof(double));
    }
    first_point_.reserve(scans + 1);
    scan_of_page_.reserve((points >> kPageBits) + 1);
}

std::size_t ScanTable::firstScanSince(double time_s) const
{
    return static_cast<std::size_t>(
        std::lower_bound(time_s_.begin(), time_s_.end(), time_s) - time_s_.begin());
}

std::size_t ScanTable::backTo(double time_s, std::size_t from) const
{
    std::size_t step = 1, high = from;
    std::size_t low = from;
    while (low > 0 && time_s_[low - 1] >= time_s)
    {
        high = low;
        low = low > step ? low - step : 0;
        step *= 2;
    }
    const auto begin = time_s_.begin();
    return static_cast<std::size_t>(
        std::lower_bound(
            begin + static_cast<std::ptrdiff_t>(low), begin + static_cast<std::ptrdiff_t>(high),
            time_s) -
        begin);
}

std::size_t ScanTable::forwardTo(double time_s, std::size_t from) const
{
    std::size_t step = 1, low = from;
    std::size_t high = from;
    while (high < size() && time_s_[high] <= time_s)
    {
        low = high;
        high = std::min(size(), high + step);
        step *= 2;
    }
    const auto begin = time_s_.begin();
    return static_cast<std::size_t>(
        std::upper_bound(
            begin + static_cast<std::ptrdiff_t>(low), begin + static_cast<std::ptrdiff_t>(high),
            time_s) -
        begin);
}

std::size_t ScanTable::bytes() const
{
    return size() * 4 * sizeof(double) + first_point_.size() * sizeof(std::uint64_t) +
           scan_of_page_.size() * sizeof(std::uint32_t);
}
}  // namespace rtob

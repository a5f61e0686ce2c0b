// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/core/scan_table.h>
#include <cstddef>
#include <vector>

namespace rtob
{
/// Finds the visits: the ranges of consecutive scans that were taken inside a box (S_t*,
/// sec. 2.3.3).
///
/// A tree over time, not over space: each node holds the bounds of the vehicle's positions over
/// 16 * 8^level consecutive scans. A place where the vehicle has been for hours is one node, so the
/// cost follows the number of visits, and that is bounded by `max_ranges`.
class VisitIndex
{
 public:
    void append(double x, double y);
    void clear() { levels_.clear(), size_ = 0; }

    /// Ranges in order of time that hold every scan taken in `box`, no two adjacent. Exact while
    /// the tree needs fewer than max_ranges ranges on a level; past that, ranges that are partly
    /// outside stay whole, so whoever uses them checks the positions.
    /// @param table the positions, as appended here.
    void query(
        const Box& box, const ScanTable& table, std::size_t max_ranges,
        std::vector<ScanRange>& ranges) const;

    [[nodiscard]] std::size_t bytes() const;

 private:
    static constexpr std::size_t kLeafScans = 16, kFanOut = 8;
    struct Bounds
    {
        float min_x, min_y, max_x, max_y;
    };

    struct Node
    {
        std::size_t level, index;
    };
    void descend(
        Node node, const Box& box, const ScanTable& table, std::size_t& budget,
        std::vector<ScanRange>& ranges) const;
    void scanLeaf(
        const ScanRange& leaf, const Box& box, const ScanTable& table,
        std::vector<ScanRange>& ranges) const;
    [[nodiscard]] ScanRange scansOf(Node node) const;

    std::vector<std::vector<Bounds>> levels_;
    std::size_t size_ = 0;
};
}  // namespace rtob

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
/// cost follows the number of visits, and that is bounded by `max_ranges`. The tree is searched
/// level by level, and no further once a level needs too many nodes.
class VisitIndex
{
 public:
    void append(double x, double y);
    /// A scan is elsewhere now. Its nodes grow and do not shrink: no scan is missed, some are
    /// looked at in vain.
    void move(std::size_t scan, double x, double y);
    void clear() { *this = VisitIndex(); }
    /// Empty again, with the room it has: append() allocates nothing until it is used up.
    void restart();
    /// Room for so many scans in all: append() allocates nothing until then.
    void reserve(std::size_t scans);

    /// Ranges in order of time that hold every scan taken in `box`, no two adjacent, at most
    /// max_ranges. Exact as long as they are fewer and the tree's levels need no more than a few
    /// nodes a range; past that they also hold scans around the visits, evenly over time, so
    /// whoever uses them checks the positions. Not for two threads at once.
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

    /// Scans that may be in the box: all of them are (inside), or those of one node perhaps.
    struct Part
    {
        ScanRange scans;
        bool inside;
    };
    [[nodiscard]] std::size_t scansPerNode(std::size_t level) const;
    void growTop();
    bool refine(
        std::size_t level, const Box& box, const ScanTable& table, std::size_t max_ranges) const;
    template <class Add>
    void openNode(
        const ScanRange& node, std::size_t level, const Box& box, const ScanTable& table,
        const Add& add) const;

    std::vector<std::vector<Bounds>> levels_;
    std::vector<std::vector<Bounds>> prepared_;  ///< empty, reserved; the next level is the last
    std::size_t size_ = 0;
    mutable std::vector<Part> parts_, finer_;  ///< buffers of query()
};
}  // namespace rtob

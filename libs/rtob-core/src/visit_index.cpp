// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/visit_index.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace rtob
{
namespace
{
// Bounds are floats to save memory: rounded outwards, so that a node never hides a scan.
float below(double v)
{
    return std::nextafterf(static_cast<float>(v), -INFINITY);
}
float above(double v)
{
    return std::nextafterf(static_cast<float>(v), INFINITY);
}

void add_range(std::vector<ScanRange>& ranges, const ScanRange& range)
{
    if (!ranges.empty() && ranges.back().end == range.first)
        ranges.back().end = range.end;
    else
        ranges.push_back(range);
}
}  // namespace

void VisitIndex::append(double x, double y)
{
    const Bounds here{below(x), below(y), above(x), above(y)};
    std::size_t index = size_ / kLeafScans;
    for (std::size_t level = 0;; ++level)
    {
        if (level == levels_.size())
        {
            levels_.emplace_back();
            // A new top: it covers all that the level below holds so far.
            if (level > 0)
                for (const Bounds& b : levels_[level - 1])
                {
                    if (levels_[level].empty()) levels_[level].push_back(b);
                    Bounds& top = levels_[level].front();
                    top = {
                        std::min(top.min_x, b.min_x), std::min(top.min_y, b.min_y),
                        std::max(top.max_x, b.max_x), std::max(top.max_y, b.max_y)};
                }
        }
        auto& nodes = levels_[level];
        if (index == nodes.size()) nodes.push_back(here);
        Bounds& node = nodes[index];
        node = {
            std::min(node.min_x, here.min_x), std::min(node.min_y, here.min_y),
            std::max(node.max_x, here.max_x), std::max(node.max_y, here.max_y)};
        if (nodes.size() == 1) break;
        index /= kFanOut;
    }
    ++size_;
}

ScanRange VisitIndex::scansOf(Node node) const
{
    std::size_t scans = kLeafScans;
    for (std::size_t l = 0; l < node.level; ++l) scans *= kFanOut;
    return {node.index * scans, std::min(size_, (node.index + 1) * scans)};
}

void VisitIndex::query(
    const Box& box, const ScanTable& table, std::size_t max_ranges,
    std::vector<ScanRange>& ranges) const
{
    ranges.clear();
    if (levels_.empty()) return;
    std::size_t budget = 4 * max_ranges;  // nodes to open: about two a range and its neighbours
    descend({levels_.size() - 1, 0}, box, table, budget, ranges);
}

void VisitIndex::descend(
    Node node, const Box& box, const ScanTable& table, std::size_t& budget,
    std::vector<ScanRange>& ranges) const
{
    const Bounds& b = levels_[node.level][node.index];
    if (b.min_x > box.max_x || b.max_x < box.min_x || b.min_y > box.max_y || b.max_y < box.min_y)
        return;
    const bool inside = b.min_x >= box.min_x && b.max_x <= box.max_x && b.min_y >= box.min_y &&
                        b.max_y <= box.max_y;
    if (inside || budget == 0) return add_range(ranges, scansOf(node));
    --budget;
    if (node.level == 0) return scanLeaf(scansOf(node), box, table, ranges);
    const std::size_t end = std::min(levels_[node.level - 1].size(), (node.index + 1) * kFanOut);
    for (std::size_t child = node.index * kFanOut; child < end; ++child)
        descend({node.level - 1, child}, box, table, budget, ranges);
}

void VisitIndex::scanLeaf(
    const ScanRange& leaf, const Box& box, const ScanTable& table,
    std::vector<ScanRange>& ranges) const
{
    for (std::size_t scan = leaf.first; scan < leaf.end; ++scan)
        if (box.contains(table.x(scan), table.y(scan))) add_range(ranges, {scan, scan + 1});
}

std::size_t VisitIndex::bytes() const
{
    std::size_t bytes = 0;
    for (const auto& nodes : levels_) bytes += nodes.size() * sizeof(Bounds);
    return bytes;
}
}  // namespace rtob

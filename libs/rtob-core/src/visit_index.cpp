// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/visit_index.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

template <class Bounds>
bool apart(const Bounds& b, const Box& box)
{
    return b.min_x > box.max_x || b.max_x < box.min_x || b.min_y > box.max_y || b.max_y < box.min_y;
}

template <class Bounds>
bool within(const Bounds& b, const Box& box)
{
    return b.min_x >= box.min_x && b.max_x <= box.max_x && b.min_y >= box.min_y &&
           b.max_y <= box.max_y;
}

template <class Bounds>
Bounds joined(const Bounds& a, const Bounds& b)
{
    return {
        std::min(a.min_x, b.min_x), std::min(a.min_y, b.min_y), std::max(a.max_x, b.max_x),
        std::max(a.max_y, b.max_y)};
}

// An entering and a leaving node a visit, and twice that for visits that a coarse level mistakes.
constexpr std::size_t kPartsPerRange = 4;
}  // namespace

void VisitIndex::append(double x, double y)
{
    const Bounds here{below(x), below(y), above(x), above(y)};
    std::size_t index = size_ / kLeafScans;
    for (std::size_t level = 0;; ++level)
    {
        if (level == levels_.size()) growTop();
        auto& nodes = levels_[level];
        if (index == nodes.size()) nodes.push_back(here);
        nodes[index] = joined(nodes[index], here);
        if (nodes.size() == 1) break;
        index /= kFanOut;
    }
    ++size_;
}

void VisitIndex::move(std::size_t scan, double x, double y)
{
    const Bounds here{below(x), below(y), above(x), above(y)};
    std::size_t index = scan / kLeafScans;
    for (auto& nodes : levels_)
    {
        nodes[index] = joined(nodes[index], here);
        index /= kFanOut;
    }
}

void VisitIndex::reserve(std::size_t scans)
{
    prepared_.clear();
    std::size_t nodes = scans;
    for (std::size_t level = 0; nodes > 1; ++level)
    {
        nodes = nodes / (level == 0 ? kLeafScans : kFanOut) + 1;
        if (level >= levels_.size()) prepared_.emplace_back();
        (level < levels_.size() ? levels_[level] : prepared_.back()).reserve(nodes);
    }
    levels_.reserve(levels_.size() + prepared_.size());
    std::reverse(prepared_.begin(), prepared_.end());
    prepared_.reserve(levels_.size() + prepared_.size());
}

void VisitIndex::restart()
{
    for (; !levels_.empty(); levels_.pop_back())
    {
        levels_.back().clear();
        prepared_.push_back(std::move(levels_.back()));
    }
    size_ = 0;
}

/// Adds a level of one node, over all that the level below holds so far.
void VisitIndex::growTop()
{
    if (prepared_.empty())
        levels_.emplace_back();
    else
    {
        levels_.push_back(std::move(prepared_.back()));
        prepared_.pop_back();
    }
    if (levels_.size() == 1) return;
    const auto& below_top = levels_[levels_.size() - 2];
    Bounds top = below_top.front();
    for (const Bounds& b : below_top) top = joined(top, b);
    levels_.back().push_back(top);
}

std::size_t VisitIndex::scansPerNode(std::size_t level) const
{
    std::size_t scans = kLeafScans;
    for (std::size_t l = 0; l < level; ++l) scans *= kFanOut;
    return scans;
}

void VisitIndex::query(
    const Box& box, const ScanTable& table, std::size_t max_ranges,
    std::vector<ScanRange>& ranges) const
{
    ranges.clear();
    if (levels_.empty() || apart(levels_.back().front(), box)) return;
    for (auto* parts : {&parts_, &finer_})
    {
        parts->clear();
        parts->reserve(kPartsPerRange * max_ranges + kLeafScans);
    }
    parts_.push_back({{0, size_}, within(levels_.back().front(), box)});
    for (std::size_t level = levels_.size(); level-- > 0;)
        if (!refine(level, box, table, max_ranges)) break;
    for (const Part& part : parts_)
        if (!ranges.empty() && ranges.back().end == part.scans.first)
            ranges.back().end = part.scans.end;
        else
            ranges.push_back(part.scans);
}

/// Replaces the level's nodes among the parts by what of them may be in the box; false, and
/// nothing is changed, if that makes too many.
bool VisitIndex::refine(
    std::size_t level, const Box& box, const ScanTable& table, std::size_t max_ranges) const
{
    finer_.clear();
    std::size_t ranges = 0;
    const auto add = [&](const Part& part)
    {
        const bool adjacent = !finer_.empty() && finer_.back().scans.end == part.scans.first;
        if (adjacent && part.inside && finer_.back().inside)
            finer_.back().scans.end = part.scans.end;
        else
            finer_.push_back(part);
        if (!adjacent) ++ranges;
    };
    for (const Part& part : parts_)
    {
        if (part.inside)
            add(part);
        else
            openNode(part.scans, level, box, table, add);
        if (ranges > max_ranges || finer_.size() > kPartsPerRange * max_ranges) return false;
    }
    parts_.swap(finer_);
    return true;
}

template <class Add>
void VisitIndex::openNode(
    const ScanRange& node, std::size_t level, const Box& box, const ScanTable& table,
    const Add& add) const
{
    if (level == 0)
    {
        for (std::size_t scan = node.first; scan < node.end; ++scan)
            if (box.contains(table.x(scan), table.y(scan))) add(Part{{scan, scan + 1}, true});
        return;
    }
    const std::size_t scans = scansPerNode(level - 1);
    for (std::size_t first = node.first; first < node.end; first += scans)
    {
        const Bounds& child = levels_[level - 1][first / scans];
        if (!apart(child, box))
            add(Part{{first, std::min(first + scans, node.end)}, within(child, box)});
    }
}

std::size_t VisitIndex::bytes() const
{
    std::size_t bytes = 0;
    for (const auto& nodes : levels_) bytes += nodes.size() * sizeof(Bounds);
    return bytes;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/random.h>
#include <rtob/core/visit_index.h>

#include <cmath>
#include <vector>

using rtob::Box;
using rtob::ScanRange;

namespace
{
constexpr std::size_t kMany = 100000;  // more ranges than any walk here makes

/// Positions of a vehicle, as the index and as the table keep them.
struct Walk
{
    rtob::ScanTable table;
    rtob::VisitIndex visits;

    void add(double x, double y)
    {
        table.append(static_cast<double>(table.size()), {x, y, 0}, 1);
        visits.append(x, y);
    }

    void move(std::size_t scan, double x, double y)
    {
        table.move(scan, {x, y, 0});
        visits.move(scan, x, y);
    }

    [[nodiscard]] std::vector<ScanRange> query(const Box& box, std::size_t max_ranges) const
    {
        std::vector<ScanRange> ranges;
        visits.query(box, table, max_ranges, ranges);
        return ranges;
    }

    [[nodiscard]] std::vector<bool> inside(const Box& box) const
    {
        std::vector<bool> scans(table.size());
        for (std::size_t i = 0; i < table.size(); ++i)
            scans[i] = box.contains(table.x(i), table.y(i));
        return scans;
    }
};

Walk random_walk(std::size_t scans, std::uint64_t seed)
{
    rtob::Random random(seed);
    Walk walk;
    double x = 0, y = 0;
    for (std::size_t i = 0; i < scans; ++i)
    {
        walk.add(x, y);
        x += random.uniform() - 0.5;
        y += random.uniform() - 0.5;
    }
    return walk;
}

/// In the box, out of it, in, out ...: the most visits that can be.
Walk border_walk(std::size_t scans)
{
    Walk walk;
    for (std::size_t i = 0; i < scans; ++i) walk.add(i % 2 == 0 ? 0.0 : 10.0, 0);
    return walk;
}

std::vector<bool> marked(const std::vector<ScanRange>& ranges, std::size_t scans)
{
    std::vector<bool> in(scans);
    for (const ScanRange& range : ranges)
        for (std::size_t i = range.first; i < range.end; ++i) in[i] = true;
    return in;
}

void expect_in_order_and_apart(const std::vector<ScanRange>& ranges)
{
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
        EXPECT_LT(ranges[i].first, ranges[i].end);
        if (i == 0) continue;
        EXPECT_LT(ranges[i - 1].end, ranges[i].first);
    }
}

void expect_equals_brute_force(const Walk& walk, rtob::Random& random)
{
    const std::size_t scans = walk.table.size();
    for (int i = 0; i < 100; ++i)
    {
        const Box box = Box::around(
            20 * random.uniform() - 10, 20 * random.uniform() - 10, 8 * random.uniform());
        const auto ranges = walk.query(box, kMany);
        ASSERT_EQ(marked(ranges, scans), walk.inside(box)) << scans << " scans, box " << i;
        expect_in_order_and_apart(ranges);
    }
}
}  // namespace

TEST(VisitIndex, EqualsBruteForceOnRandomWalks)
{
    // Sizes around the tree's own: one leaf (16), one node of leaves (128), and more.
    for (const std::size_t scans : {1, 15, 16, 17, 127, 128, 129, 1024, 1025, 5000})
    {
        const Walk walk = random_walk(scans, scans);
        rtob::Random random(7);
        expect_equals_brute_force(walk, random);
    }
}

TEST(VisitIndex, EqualsBruteForceWhenScansHaveMoved)
{
    for (const std::size_t scans : {1, 16, 129, 2000})
    {
        Walk walk = random_walk(scans, scans);
        rtob::Random random(3);
        for (std::size_t scan = scans / 3; scan < scans; ++scan)
            walk.move(scan, walk.table.x(scan) + 4 * random.uniform(), walk.table.y(scan) - 3.0);
        expect_equals_brute_force(walk, random);
    }
}

TEST(VisitIndex, AScanOnTheBordersIsInside)
{
    Walk walk;
    walk.add(0.1, 0.7);  // no floats: the index must not round them out of the box
    EXPECT_EQ(walk.query({0.1, 0.7, 0.1, 0.7}, kMany).size(), 1u);
    EXPECT_EQ(walk.query({0, 0, 0.1, 0.7}, kMany).size(), 1u);
    EXPECT_TRUE(walk.query({0.10000001, 0, 1, 1}, kMany).empty());
}

TEST(VisitIndex, IsExactWithJustEnoughRanges)
{
    const Walk walk = border_walk(1000);
    const Box box{-1, -1, 1, 1};
    EXPECT_EQ(marked(walk.query(box, 500), 1000), walk.inside(box));
}

TEST(VisitIndex, HonoursItsBoundWithASuperset)
{
    const Box box{-1, -1, 1, 1};
    const Walk border = border_walk(40000), random = random_walk(40000, 3);
    for (const Walk* walk : {&border, &random})
        for (const std::size_t max_ranges : {1, 2, 10, 100, 512})
        {
            const auto ranges = walk->query(box, max_ranges);
            EXPECT_LE(ranges.size(), max_ranges);
            expect_in_order_and_apart(ranges);
            const auto in = marked(ranges, walk->table.size());
            const auto inside = walk->inside(box);
            for (std::size_t i = 0; i < inside.size(); ++i)
                ASSERT_LE(inside[i], in[i]) << "scan " << i << " is lost";
        }
}

TEST(VisitIndex, SpendsItsBoundEvenlyOverTime)
{
    // A visit of 16 scans every 160: 6250 visits, more than the bound, over a million scans.
    Walk walk;
    for (std::size_t i = 0; i < 1000000; ++i) walk.add(i % 160 < 16 ? 0.0 : 10.0, 0);
    std::size_t scans = 0, newest_half = 0;
    const auto in = marked(walk.query({-1, -1, 1, 1}, 512), 1000000);
    for (std::size_t i = 0; i < in.size(); ++i)
    {
        scans += in[i];
        if (i >= 500000) newest_half += in[i];
    }
    EXPECT_NEAR(double(newest_half) / double(scans), 0.5, 0.05);
}

TEST(VisitIndex, AnEmptyOneFindsNothing)
{
    Walk walk;
    EXPECT_TRUE(walk.query({-1, -1, 1, 1}, kMany).empty());
    walk.add(0, 0);
    walk.visits.clear();
    EXPECT_TRUE(walk.query({-1, -1, 1, 1}, kMany).empty());
    EXPECT_EQ(walk.visits.bytes(), 0u);
}

TEST(VisitIndex, CostsLittleMoreThanAByteAScan)
{
    const Walk walk = random_walk(100000, 5);
    // 16 bytes for each 16 scans, and a seventh of that for the levels above.
    EXPECT_LT(static_cast<double>(walk.visits.bytes()), 1.2 * 100000);
}

TEST(VisitIndex, IsTheSameWithRoomReserved)
{
    constexpr std::size_t scans = 1500;
    rtob::ScanTable table;
    rtob::VisitIndex plain, reserved;
    reserved.reserve(200);
    rtob::Random random(3);
    for (std::size_t i = 0; i < scans; ++i)
    {
        if (i == 100) reserved.reserve(1200);  // and grows past that
        const double x = 10 * random.uniform(), y = 10 * random.uniform();
        table.append(0.1 * static_cast<double>(i), {x, y, 0}, 1);
        plain.append(x, y);
        reserved.append(x, y);
    }
    EXPECT_EQ(reserved.bytes(), plain.bytes());
    std::vector<ScanRange> from_plain, from_reserved;
    const Box box = Box::around(5, 5, 3);
    plain.query(box, table, scans, from_plain);
    reserved.query(box, table, scans, from_reserved);
    ASSERT_GT(from_plain.size(), 10u);
    EXPECT_EQ(marked(from_reserved, scans), marked(from_plain, scans));
}

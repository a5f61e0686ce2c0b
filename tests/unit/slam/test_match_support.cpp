// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/match_support.h>
#include <test_map.h>

using namespace rtob;

namespace
{
/// Scan k has 10 points, 1 m apart along y, at x = 10 k; all are in the reference, seen from
/// (100, 0).
struct Lines
{
    test::TestMap map;
    Reference reference;

    Lines()
    {
        for (int k = 0; k < 5; ++k)
            map.add(
                k, {}, 10,
                [&](std::uint32_t i)
                { return std::pair(10.0f * static_cast<float>(k), static_cast<float>(i)); });
        reference.origin_x = 100;
        for (std::uint64_t i = 0; i < map.points_map.size(); ++i)
        {
            reference.indices.push_back(i);
            reference.points.add(map.points_map.x[i] - 100, map.points_map.y[i]);
        }
    }

    /// @param shares how many of ten points lie on the line of each scan, 0.1 m beside it.
    [[nodiscard]] std::size_t newest(std::vector<int> points_on_scan, double x = 0) const
    {
        Points points;
        for (std::size_t k = 0; k < points_on_scan.size(); ++k)
            for (int i = 0; i < points_on_scan[k]; ++i)
                points.add(
                    10.0f * static_cast<float>(k) + 0.1f - static_cast<float>(x),
                    static_cast<float>(i));
        MatchSupport support;
        return support.newest(map.scans, reference, points.view(), x, 0);
    }
};
}  // namespace

TEST(MatchSupport, IsTheNewestScanWithPointsBesideThese)
{
    EXPECT_EQ(Lines().newest({10}), 0u);
    EXPECT_EQ(Lines().newest({5, 0, 5}), 2u);
}

TEST(MatchSupport, ATenthOfThePointsDoesNotCount)
{
    EXPECT_EQ(Lines().newest({10, 0, 0, 1}), 0u);
    EXPECT_EQ(Lines().newest({10, 0, 0, 2}), 3u);
}

TEST(MatchSupport, PointsAreSeenFromWhereTheMatchPutsThem)
{
    EXPECT_EQ(Lines().newest({0, 10}, 37.5), 1u);
}

TEST(MatchSupport, WhatLiesBesideNothingRestsOnTheBeginning)
{
    EXPECT_EQ(Lines().newest({0, 0, 0, 0, 0, 0, 0, 9}), 0u);
}

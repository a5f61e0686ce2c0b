// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/random.h>
#include <rtob/core/wide_search.h>
#include <worlds.h>

#include <algorithm>
#include <cmath>

using namespace rtob;
using namespace rtob::test;

namespace
{
// Half a cell of 0.1 m in x and in y, and half a step of yaw at the world's few metres.
constexpr double kTolerance_m = 0.15, kTolerance_rad = 0.05;

/// The reference is denser than the scan, as a map is.
Points seen_from(const Room& room, const Pose2& pose_map_vehicle, std::size_t beams)
{
    Laser laser;
    laser.beams = beams;
    laser.step_rad = 2 * M_PI / static_cast<double>(beams);
    return moved(room.scan_vehicle(pose_map_vehicle, laser), {0, 0, pose_map_vehicle.yaw});
}
}  // namespace

TEST(WideSearch, FindsCorrectionsThatIcpDoesNotReach)
{
    for (const World& world : worlds())
    {
        const Pose2& truth = world.pose_map_vehicle;
        const Points reference = seen_from(world.room, truth, 3600);
        for (const Pose2& off : {Pose2{1.2, -0.7, 0.4}, Pose2{-1.0, 0.9, -0.6}, Pose2{0, 0, 0}})
        {
            SCOPED_TRACE(world.name);
            // The scan as pre-aligned by a guess that is wrong by `off`.
            Points scan = world.room.scan_vehicle(truth);
            scan = moved(scan, {0, 0, truth.yaw - off.yaw});
            Points shifted = moved(reference, {off.x, off.y, 0});
            WideSearch search;
            const SearchResult found = search.search(scan.view(), shifted.view(), {1.5, 0.8});
            EXPECT_NEAR(found.correction.x, off.x, kTolerance_m);
            EXPECT_NEAR(found.correction.y, off.y, kTolerance_m);
            EXPECT_NEAR(wrap_angle(found.correction.yaw - off.yaw), 0, kTolerance_rad);
            EXPECT_GT(found.score, 0.6);  // a point in the cell beside the right one counts half
        }
    }
}

TEST(WideSearch, StaysInItsWindow)
{
    const World world = l_shape();
    const Points reference = seen_from(world.room, world.pose_map_vehicle, 3600);
    const Points shifted = moved(reference, {2.0, 0, 0});
    const Points scan =
        moved(world.room.scan_vehicle(world.pose_map_vehicle), {0, 0, world.pose_map_vehicle.yaw});
    WideSearch search;
    const SearchResult found = search.search(scan.view(), shifted.view(), {0.5, 0.1});
    EXPECT_LE(std::abs(found.correction.x), 0.5 + 1e-9);
    EXPECT_LE(std::abs(found.correction.y), 0.5 + 1e-9);
    EXPECT_LT(found.score, 0.6);
}

TEST(WideSearch, FindsNothingInNothing)
{
    WideSearch search;
    Points some;
    some.add(1, 1);
    EXPECT_EQ(search.search(Points().view(), some.view(), {}).score, 0);
    EXPECT_EQ(search.search(some.view(), Points().view(), {}).score, 0);
}

TEST(WideSearch, AMinimumChangesNothingButWhatIsBelowIt)
{
    const World world = l_shape();
    const Points reference = seen_from(world.room, world.pose_map_vehicle, 3600);
    const Points shifted = moved(reference, {0.9, -0.4, 0});
    const Points scan = moved(
        world.room.scan_vehicle(world.pose_map_vehicle), {0, 0, world.pose_map_vehicle.yaw + 0.2});
    WideSearch search;
    const SearchResult best = search.search(scan.view(), shifted.view(), {1.5, 0.4});
    ASSERT_GT(best.score, 0.6);
    for (const double min_score : {0.3, 0.6, best.score})
    {
        const SearchResult found =
            search.search(scan.view(), shifted.view(), {1.5, 0.4, min_score});
        EXPECT_EQ(found.score, best.score);
        EXPECT_EQ(found.correction.x, best.correction.x);
        EXPECT_EQ(found.correction.y, best.correction.y);
        EXPECT_EQ(found.correction.yaw, best.correction.yaw);
    }
    const SearchResult none =
        search.search(scan.view(), shifted.view(), {1.5, 0.4, best.score + 0.01});
    EXPECT_EQ(none.score, 0);
    EXPECT_EQ(none.correction.x, 0);
}

TEST(WideSearch, EqualsTryingAllShifts)
{
    // A cloud among clouds, no turn: every shift of whole cells is tried by hand.
    Random random(3);
    Points reference, points;
    for (int i = 0; i < 300; ++i)
        reference.add(
            static_cast<float>(12 * random.uniform() - 6),
            static_cast<float>(8 * random.uniform() - 4));
    for (std::size_t i = 0; i < 40; ++i) points.add(reference.x[i] + 0.73f, reference.y[i] - 0.52f);
    WideSearch search;
    const SearchResult found = search.search(points.view(), reference.view(), {1.0, 1e-9});
    const auto hits = [&](double dx, double dy)
    {
        int near = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = 0; j < reference.size(); ++j)
                if (std::hypot(
                        points.x[i] + dx - reference.x[j], points.y[i] + dy - reference.y[j]) < 0.1)
                {
                    ++near;
                    break;
                }
        return near;
    };
    EXPECT_NEAR(found.correction.x, -0.73, 0.11);
    EXPECT_NEAR(found.correction.y, 0.52, 0.11);
    int most = 0;
    for (int x = -10; x <= 10; ++x)
        for (int y = -10; y <= 10; ++y) most = std::max(most, hits(0.1 * x, 0.1 * y));
    EXPECT_GE(hits(found.correction.x, found.correction.y), most * 8 / 10);
}

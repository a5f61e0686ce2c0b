// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/core/global_search.h>

#include <cmath>

#include "near_pose.h"
#include "worlds.h"

namespace rtob
{
namespace
{
using test::IsNearPose;
using test::Wall;

/// Two halls side by side, alike but for a pillar in the first.
test::Room two_halls(bool with_pillar)
{
    std::vector<Wall> walls;
    for (const double x : {0.0, 20.0})
        for (const Wall& wall :
             {Wall{x, 0, x + 8, 0}, Wall{x + 8, 0, x + 8, 6}, Wall{x + 8, 6, x, 6},
              Wall{x, 6, x, 0}, Wall{x + 2, 2, x + 3, 2}})
            walls.push_back(wall);
    if (with_pillar) test::add_circle(walls, 6, 4, 0.4);
    return test::Room(walls);
}

struct Map
{
    Points points;
    ScanTable scans;

    explicit Map(const test::Room& room)
    {
        for (const Pose2 pose : {Pose2{4, 1, 0}, Pose2{4, 5, 0}, Pose2{24, 1, 0}, Pose2{24, 5, 0}})
        {
            const Points seen = test::moved(room.scan_vehicle(pose), pose);
            for (std::size_t i = 0; i < seen.size(); ++i) points.add(seen.x[i], seen.y[i]);
            scans.append(0, pose, static_cast<std::uint32_t>(seen.size()));
        }
    }
};

std::vector<PlaceCandidate> search(const Map& map, const Points& scan, std::size_t looks)
{
    MapRaster raster;
    raster.draw(map.points.view(), map.scans);
    GlobalSearch search;
    search.begin(raster, scan.view(), 0.5);
    while (!search.advance(raster, looks)) continue;
    return search.candidates();
}

TEST(GlobalSearch, FindsAScanWithAnyHeading)
{
    const auto room = two_halls(true);
    const Map map(room);
    for (const double yaw : {0.0, 1.0, 3.1, -2.2})
    {
        const Pose2 truth{3.5, 4, yaw};
        const auto found = search(map, room.scan_vehicle(truth), 1'000'000'000);
        ASSERT_FALSE(found.empty());
        // Two cells of 0.1 m and a step of 0.02 rad.
        EXPECT_THAT(found.front().pose_map_vehicle, IsNearPose(truth, 0.25, 0.03)) << yaw;
        EXPECT_GT(found.front().score, 0.9);
    }
}

TEST(GlobalSearch, InSmallPortionsItFindsTheSame)
{
    const auto room = two_halls(true);
    const Map map(room);
    const Points scan = room.scan_vehicle({24.5, 2.5, 0.4});
    const auto at_once = search(map, scan, 1'000'000'000);
    const auto in_portions = search(map, scan, 10'000);
    ASSERT_EQ(at_once.size(), in_portions.size());
    for (std::size_t k = 0; k < at_once.size(); ++k)
    {
        EXPECT_EQ(at_once[k].score, in_portions[k].score);
        EXPECT_THAT(
            at_once[k].pose_map_vehicle, IsNearPose(in_portions[k].pose_map_vehicle, 0.0, 0.0));
    }
}

TEST(GlobalSearch, ShowsThatAPlaceHasATwin)
{
    const auto room = two_halls(false);
    const Map map(room);
    const auto found = search(map, room.scan_vehicle({3.5, 4, 0.5}), 1'000'000'000);
    ASSERT_GE(found.size(), 2U);
    EXPECT_NEAR(found[0].score, found[1].score, 0.1);
    EXPECT_NEAR(std::abs(found[0].pose_map_vehicle.x - found[1].pose_map_vehicle.x), 20, 0.5);
}

TEST(GlobalSearch, NothingIsFoundForAScanOfAnotherWorldOrNone)
{
    const Map map(two_halls(true));
    std::vector<Wall> walls;
    test::add_circle(walls, 0, 0, 5.5);
    EXPECT_TRUE(search(map, test::Room(walls).scan_vehicle({}), 1'000'000).empty());
    EXPECT_TRUE(search(map, Points(), 1'000'000).empty());
    GlobalSearch in_no_map;
    const MapRaster empty;
    in_no_map.begin(empty, map.points.view(), 0.5);
    EXPECT_TRUE(in_no_map.advance(empty, 1000));
}
}  // namespace
}  // namespace rtob

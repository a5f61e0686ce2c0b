// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <rtob/map/rtob_map.h>

#include "error_message.h"
#include "room.h"

#include <cmath>
#include <type_traits>

using rtob::Points;
using rtob::Pose2;
using rtob::Reference;
using rtob::RtobMap;
using rtob::RtobMapOptions;
using rtob::test::error_message;
using rtob::test::room_4x3;
using testing::HasSubstr;

static_assert(std::is_copy_constructible_v<RtobMap> && std::is_copy_assignable_v<RtobMap>);
static_assert(std::is_move_constructible_v<RtobMap> && std::is_move_assignable_v<RtobMap>);
static_assert(std::is_base_of_v<mrpt::maps::CSimplePointsMap, RtobMap>);

namespace
{
Points two_points()
{
    Points points;
    points.add(1, 0);
    points.add(0, 2);
    return points;
}

RtobMapOptions uniform_options(int points)
{
    RtobMapOptions options;
    options.density.density = rtob::Density::Uniform;
    options.draw.points = points;
    return options;
}

/// `scans` scans of the room, 0.1 s and 1 mm apart.
RtobMap map_of_room(const RtobMapOptions& options, int scans)
{
    RtobMap map(options);
    for (int k = 0; k < scans; ++k)
    {
        const Pose2 pose{1.5 + 0.001 * k, 1.0, 0.01 * k};
        map.insertScan(map.tick(100 + 0.1 * k), pose, room_4x3().scan_vehicle(pose).view());
    }
    return map;
}
}  // namespace

TEST(RtobMap, PutsScansWhereTheVehicleWas)
{
    RtobMap map;
    const double quarter_turn = std::acos(0.0);
    map.insertScan(map.tick(50.0), {10, 20, quarter_turn}, two_points().view());
    map.insertScan(map.tick(50.5), {0, 0, 0}, two_points().view());

    ASSERT_EQ(map.size(), 4u);
    // Turned left by 90 degrees, (1, 0) lies ahead at (0, 1) and (0, 2) at (-2, 0).
    EXPECT_FLOAT_EQ(map.points().x[0], 10);
    EXPECT_FLOAT_EQ(map.points().y[0], 21);
    EXPECT_FLOAT_EQ(map.points().x[1], 8);
    EXPECT_FLOAT_EQ(map.points().y[1], 20);
    EXPECT_FLOAT_EQ(map.points().x[2], 1);
    EXPECT_EQ(map.getPointsBufferRef_z(), mrpt::aligned_std_vector<float>(4, 0.0f));
    EXPECT_EQ(map.scans().size(), 2u);
    EXPECT_DOUBLE_EQ(map.scans().time(1), 0.5);
    EXPECT_EQ(map.scans().firstPoint(1), 2u);
    EXPECT_EQ(map.view().points_map.size, 4u);
}

TEST(RtobMap, TicksForScansThatAreNotInserted)
{
    RtobMap map;
    map.tick(7.0);
    map.tick(7.25);
    const double now_s = map.tick(7.5);
    EXPECT_DOUBLE_EQ(now_s, 0.5);
    map.insertScan(now_s, {}, two_points().view());
    EXPECT_DOUBLE_EQ(map.scans().time(0), 0.5);
}

TEST(RtobMap, RefusesAScanOlderThanTheLast)
{
    RtobMap map;
    map.insertScan(2.0, {}, two_points().view());
    EXPECT_THROW(map.insertScan(1.0, {}, two_points().view()), std::invalid_argument);
    EXPECT_EQ(map.size(), 2u);  // nothing half done
    EXPECT_NO_THROW((void)map.view());
}

TEST(RtobMap, LeavesOutAScanWithoutPoints)
{
    RtobMap map;
    map.insertScan(map.tick(1), {}, {});
    EXPECT_TRUE(map.isEmpty());
    EXPECT_TRUE(map.scans().empty());
}

TEST(RtobMap, UsesAtMost16BytesAPoint)
{
    RtobMap map;
    const rtob::test::Laser laser{180, -1.5, 3.0 / 180, 6};
    for (int k = 0; k < 5000; ++k)
        map.insertScan(
            map.tick(0.1 * k), {1.5, 1, 0}, room_4x3().scan_vehicle({1.5, 1, 0}, laser).view());
    ASSERT_EQ(map.size(), 5000u * 180u);
    EXPECT_LE(static_cast<double>(map.bytesInUse()), 16.0 * static_cast<double>(map.size()));
    EXPECT_GE(map.bytesInUse(), 12 * map.size());  // x, y, z are counted
}

TEST(RtobMap, DrawsAsManyPointsAsAskedSeenFromTheVehicle)
{
    RtobMap map = map_of_room(uniform_options(500), 10);
    Reference reference;
    map.draw({1.5, 1.0, 0.3}, reference);
    ASSERT_EQ(reference.points.size(), 500u);
    EXPECT_EQ(reference.origin_x, 1.5);
    for (std::size_t i = 0; i < reference.points.size(); ++i)
    {
        const auto k = reference.indices[i];
        ASSERT_NEAR(reference.points.x[i] + 1.5, map.points().x[k], 1e-6);
        ASSERT_NEAR(reference.points.y[i] + 1.0, map.points().y[k], 1e-6);
    }
}

TEST(RtobMap, DrawsInsideTheGateOfItsOptions)
{
    RtobMapOptions options = uniform_options(3000);
    options.density.gate_m = 1.2;
    RtobMap map = map_of_room(options, 2);  // 720 points: all that lie inside are drawn
    Reference reference;
    map.draw({1.5, 1.0, 0}, reference);
    std::size_t inside = 0;
    for (std::size_t i = 0; i < map.size(); ++i)
        inside +=
            std::abs(map.points().x[i] - 1.5) <= 1.2 && std::abs(map.points().y[i] - 1.0) <= 1.2;
    EXPECT_EQ(reference.points.size(), inside);
    EXPECT_LT(inside, map.size());
}

TEST(RtobMap, DrawsInsideBothGates)
{
    RtobMapOptions options = uniform_options(3000);
    options.density.gate_m = 1.2;
    RtobMap map = map_of_room(options, 2);
    Reference reference;
    map.draw({1.5, 1.0, 0}, rtob::Box{-9, -9, 1.4, 9}, 0, reference);
    std::size_t inside = 0;
    for (std::size_t i = 0; i < map.size(); ++i)
        inside += std::abs(map.points().x[i] - 1.5) <= 1.2 &&
                  std::abs(map.points().y[i] - 1.0) <= 1.2 && map.points().x[i] <= 1.4;
    EXPECT_EQ(reference.points.size(), inside);
    EXPECT_GT(inside, 0u);
}

TEST(RtobMap, DrawsOnlyNewScansWhereAsked)
{
    RtobMap map = map_of_room(uniform_options(3000), 4);
    Reference reference;
    map.draw({1.5, 1.0, 0}, std::nullopt, 3, reference);
    ASSERT_FALSE(reference.indices.empty());
    for (const auto i : reference.indices) EXPECT_GE(i, map.scans().firstPoint(3));
}

TEST(RtobMap, DrawsTheSameFromTheSameSeed)
{
    RtobMapOptions options = uniform_options(300);
    RtobMap a = map_of_room(options, 10), b = map_of_room(options, 10);
    options.seed = 2;
    RtobMap other = map_of_room(options, 10);
    Reference from_a, from_b, from_other;
    for (int k = 0; k < 3; ++k)
    {
        a.draw({1.5, 1, 0}, from_a);
        b.draw({1.5, 1, 0}, from_b);
        other.draw({1.5, 1, 0}, from_other);
        EXPECT_EQ(from_a.indices, from_b.indices);
        EXPECT_NE(from_a.indices, from_other.indices);
    }
}

TEST(RtobMap, CopiesPointsScansAndOptions)
{
    RtobMap map = map_of_room(uniform_options(77), 3);
    map.likelihoodOptions.decimation = 3;
    map.genericMapParams.enableSaveAs3DObject = false;
    const RtobMap copy(map);
    RtobMap assigned;
    assigned = map;
    map.clear();
    for (const RtobMap* m : {&copy, static_cast<const RtobMap*>(&assigned)})
    {
        EXPECT_EQ(m->size(), 3u * 360u);
        EXPECT_EQ(m->scans().size(), 3u);
        EXPECT_EQ(m->options().draw.points, 77);
        EXPECT_EQ(m->likelihoodOptions.decimation, 3u);
        EXPECT_FALSE(m->genericMapParams.enableSaveAs3DObject);
        EXPECT_NO_THROW((void)m->view());
    }
}

TEST(RtobMap, ClearedIsAsNew)
{
    RtobMap map = map_of_room(uniform_options(100), 3);
    Reference before, after;
    map_of_room(uniform_options(100), 3).draw({1, 1, 0}, before);
    map.draw({1, 1, 0}, after);  // uses up some of the generator
    map.clear();
    EXPECT_TRUE(map.isEmpty());
    EXPECT_TRUE(map.scans().empty());
    EXPECT_EQ(map.clock().now(), 0.0);
    EXPECT_EQ(map.options().draw.points, 100);

    for (int k = 0; k < 3; ++k)
    {
        const Pose2 pose{1.5 + 0.001 * k, 1.0, 0.01 * k};
        map.insertScan(map.tick(100 + 0.1 * k), pose, room_4x3().scan_vehicle(pose).view());
    }
    map.draw({1, 1, 0}, after);
    EXPECT_EQ(after.indices, before.indices);
}

TEST(RtobMap, RefusesPointsAddedBehindItsBack)
{
    RtobMap map;
    map.insertScan(0, {}, two_points().view());
    map.insertPoint(1, 2, 3);
    const auto message = error_message<std::logic_error>([&] { (void)map.view(); });
    EXPECT_THAT(message, HasSubstr("3 points"));
    EXPECT_THAT(message, HasSubstr("insertObservation"));
}

TEST(RtobMap, RefusesOptionsOutOfRange)
{
    RtobMapOptions options;
    options.draw.points = 1;
    EXPECT_THROW(RtobMap{options}, std::invalid_argument);
    RtobMap map;
    EXPECT_THROW(map.setOptions(options), std::invalid_argument);
    EXPECT_EQ(map.options().draw.points, RtobMapOptions{}.draw.points);
}

TEST(RtobMap, DescribesItself)
{
    const RtobMap map = map_of_room(uniform_options(100), 3);
    EXPECT_EQ(map.asString(), "RTOB map: 1080 points of 3 scans over 0.2 s, density uniform");
    EXPECT_THAT(RtobMap().asString(), HasSubstr("0 points of 0 scans"));
}

TEST(RtobMap, ShowsItself)
{
    const RtobMap map = map_of_room(uniform_options(100), 1);
    mrpt::opengl::CSetOfObjects objects;
    map.getVisualizationInto(objects);
    EXPECT_FALSE(objects.empty());
}

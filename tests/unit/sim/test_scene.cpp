// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/random.h>
#include <rtob/sim/scene.h>

using namespace rtob::sim;

namespace
{
constexpr double pi = 3.14159265358979323846;

Object thing(std::vector<Shape> shapes, double z_min_m = 0, double z_max_m = 3)
{
    Object object;
    object.shapes_object = std::move(shapes);
    object.z_min_m = z_min_m;
    object.z_max_m = z_max_m;
    return object;
}

Scene scene_of(std::vector<Object> objects)
{
    World world;
    world.objects = std::move(objects);
    return Scene(world);
}

Beam flat_beam(double x, double y, double angle_rad, double z_m = 1)
{
    return {{x, y}, z_m, {std::cos(angle_rad), std::sin(angle_rad)}, 0};
}

/// Segments, circles and arcs anywhere in 20 m x 20 m.
Scene random_scene(rtob::Random& random, int shapes)
{
    const auto anywhere = [&] { return Point2{20 * random.uniform(), 20 * random.uniform()}; };
    std::vector<Object> objects;
    for (int i = 0; i < shapes; ++i) switch (random.below(3))
        {
            case 0:
                objects.push_back(thing({Segment{anywhere(), anywhere()}}));
                break;
            case 1:
                objects.push_back(thing({Arc{anywhere(), 2 * random.uniform() + 0.01}}));
                break;
            default:
                objects.push_back(thing({Arc{
                    anywhere(), 3 * random.uniform() + 0.01, 7 * random.uniform(),
                    6 * random.uniform() + 0.1}}));
        }
    return scene_of(objects);
}
}  // namespace

TEST(SimScene, MeetsASegmentAtTheDistanceOfPlaneGeometry)
{
    const auto scene = scene_of({thing({Segment{{2, -1}, {2, 5}}})});
    EXPECT_DOUBLE_EQ(scene.cast(flat_beam(0, 0, 0)).distance_m, 2);
    // At 60 degrees the wall at x = 2 is 2 / cos 60 = 4 m away.
    EXPECT_NEAR(scene.cast(flat_beam(0, 0, pi / 3)).distance_m, 4, 1e-12);
    EXPECT_FALSE(scene.cast(flat_beam(0, 0, -pi / 3)).met());  // would meet at y = -3.46
    EXPECT_FALSE(scene.cast(flat_beam(0, 0, pi)).met());       // behind
    EXPECT_FALSE(scene.cast(flat_beam(2, 6, -pi / 2)).met());  // along it
}

TEST(SimScene, MeetsACircleFromOutsideAndInside)
{
    const auto scene = scene_of({thing({Arc{{5, 0}, 2}})});
    EXPECT_DOUBLE_EQ(scene.cast(flat_beam(0, 0, 0)).distance_m, 3);
    EXPECT_DOUBLE_EQ(scene.cast(flat_beam(5, 0, 0)).distance_m, 2);
    // One metre beside the middle: half chord sqrt(4 - 1).
    EXPECT_NEAR(scene.cast(flat_beam(0, 1, 0)).distance_m, 5 - std::sqrt(3.0), 1e-12);
    EXPECT_FALSE(scene.cast(flat_beam(0, 2.1, 0)).met());
}

TEST(SimScene, PassesThroughTheOpenSideOfAnArc)
{
    // The right half of a circle: a beam from the left goes in and meets it from inside.
    const auto scene = scene_of({thing({Arc{{5, 0}, 2, -pi / 2, pi}})});
    EXPECT_DOUBLE_EQ(scene.cast(flat_beam(0, 0, 0)).distance_m, 7);
    EXPECT_DOUBLE_EQ(scene.cast(flat_beam(10, 0, pi)).distance_m, 3);
}

TEST(SimScene, PassesAboveAndBelowThings)
{
    const auto scene =
        scene_of({thing({Segment{{2, -1}, {2, 1}}}, 0, 0.6), thing({Segment{{4, -1}, {4, 1}}})});
    EXPECT_DOUBLE_EQ(scene.cast(flat_beam(0, 0, 0, 0.5)).distance_m, 2);
    EXPECT_DOUBLE_EQ(scene.cast(flat_beam(0, 0, 0, 0.7)).distance_m, 4);
    // Rising 5 degrees from 0.5 m: at 2 m it is at 0.675 m, above the low thing.
    Beam rising = flat_beam(0, 0, 0, 0.5);
    rising.slope = std::tan(5 * pi / 180);
    EXPECT_DOUBLE_EQ(scene.cast(rising).distance_m, 4);
}

TEST(SimScene, TiltedBeamsEndAtFloorAndCeiling)
{
    World world;
    world.ceiling_m = 2.5;
    const Scene scene(world);
    Beam beam = flat_beam(0, 0, 0, 1);
    EXPECT_FALSE(scene.cast(beam).met());
    beam.slope = -0.1;
    EXPECT_DOUBLE_EQ(scene.cast(beam).distance_m, 10);
    beam.slope = 0.1;
    EXPECT_DOUBLE_EQ(scene.cast(beam).distance_m, 15);
}

TEST(SimScene, NoBeamSlipsThroughACorner)
{
    const Point2 corner{0.1 + 0.2, 1.0 / 3};
    const auto scene =
        scene_of({thing({Segment{{-3, 1.0 / 3}, corner}}), thing({Segment{corner, {0.3, -4}}})});
    rtob::Random random(1);
    for (int i = 0; i < 1000; ++i)
    {
        Beam beam{{-2 * random.uniform(), -2 * random.uniform()}, 1, {}, 0};
        const Point2 to_corner = corner - beam.origin_map;
        beam.direction_map = (1 / length(to_corner)) * to_corner;
        EXPECT_NEAR(scene.cast(beam).distance_m, length(to_corner), 1e-6);
    }
}

TEST(SimScene, ASelectionLosesNothingThatItsBundleMeets)
{
    rtob::Random random(7);
    Selection selection;
    std::size_t selected = 0, beams = 0, met = 0;
    for (int round = 0; round < 300; ++round)
    {
        const auto scene = random_scene(random, 40);
        Bundle bundle;
        bundle.origin_map = {20 * random.uniform(), 20 * random.uniform()};
        bundle.spread_m = 0.3 * random.uniform();
        bundle.from_rad = 20 * random.uniform() - 10;
        bundle.sweep_rad = random.uniform();
        bundle.reach_m = 1 + 8 * random.uniform();
        scene.select(bundle, selection);
        selected += selection.segments.size() + selection.arcs.size();
        for (int i = 0; i < 30; ++i, ++beams)
        {
            const double off_rad = 7 * random.uniform(), off_m = bundle.spread_m * random.uniform();
            const Beam beam = flat_beam(
                bundle.origin_map.x + off_m * std::cos(off_rad),
                bundle.origin_map.y + off_m * std::sin(off_rad),
                bundle.from_rad + bundle.sweep_rad * random.uniform());
            const double distance_m = scene.cast(beam).distance_m;
            if (distance_m > bundle.reach_m) continue;
            ++met;
            EXPECT_EQ(scene.cast(beam, selection).distance_m, distance_m) << "round " << round;
        }
    }
    EXPECT_GT(met, beams / 4);                 // else the test has tested nothing
    EXPECT_LT(selected, 300u * 40u * 6 / 10);  // and the selection has selected nothing
}

TEST(SimScene, ShowsHidesAndMovesByTheTimetable)
{
    Object door = thing({Segment{{0, 0}, {1, 0}}});  // hinge at its own origin
    door.placements = {{10, {2, 0, pi / 2}}, {12, {2, 0, 0}}};
    Object box = thing({Segment{{1, -1}, {1, 1}}});
    box.present = {{5, 8}};
    auto scene = scene_of({door, box});
    const auto seen_at = [&](double time_s)
    {
        scene.moveTo(time_s);
        return scene.cast(flat_beam(0, 0.5, 0)).distance_m;
    };
    EXPECT_DOUBLE_EQ(seen_at(0), 2);  // the door across the beam
    EXPECT_DOUBLE_EQ(seen_at(5), 1);  // the box before it
    EXPECT_DOUBLE_EQ(seen_at(8), 2);  // gone
    // Half open at 45 degrees: the beam at y = 0.5 meets it at x = 2.5.
    EXPECT_NEAR(seen_at(11), 2.5, 1e-12);
    EXPECT_FALSE(std::isfinite(seen_at(12)));
}

TEST(SimScene, APersonWalksThereAndBack)
{
    const auto person = walking_person({{{0, 0}, {3, 0}}, 1.5, 10, 100, 0.2, 1.8, true});
    EXPECT_FALSE(person.isPresent(9));
    EXPECT_TRUE(person.isPresent(10));
    EXPECT_DOUBLE_EQ(person.pose_map_object(11).x, 1.5);
    EXPECT_DOUBLE_EQ(person.pose_map_object(12).x, 3);
    EXPECT_DOUBLE_EQ(person.pose_map_object(13).x, 1.5);
    EXPECT_DOUBLE_EQ(person.pose_map_object(14).x, 0);
    EXPECT_FALSE(person.isPresent(100));
    const auto leaves = walking_person({{{0, 0}, {3, 0}}, 1.5, 10, 100, 0.2, 1.8, false});
    EXPECT_FALSE(leaves.isPresent(12.1));
}

TEST(SimScene, ClearanceIsZeroInsideSolidThingsAndOnlyThere)
{
    Object pillar = thing({Arc{{3, 0}, 1}}, 0, 2);
    pillar.is_solid = true;
    const auto scene = scene_of({pillar, thing({Arc{{0, 0}, 10}})});  // in a round room
    EXPECT_DOUBLE_EQ(scene.clearance_m({0, 0}, 1), 2);
    EXPECT_DOUBLE_EQ(scene.clearance_m({3.2, 0}, 1), 0);
    EXPECT_DOUBLE_EQ(scene.clearance_m({3, 0}, 2.5), 7);  // above the pillar
}

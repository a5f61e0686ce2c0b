// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/sim/laser.h>

using namespace rtob::sim;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// Nothing but geometry.
LaserOptions perfect_laser()
{
    LaserOptions options;
    options.noise_m = options.noise_per_m = options.dropout = 0;
    return options;
}

Object wall(Point2 from, Point2 to, Surface surface = {})
{
    Object object;
    object.shapes_object = {Segment{from, to}};
    object.surface = surface;
    return object;
}

Scene square_room()
{
    World world;
    world.objects = {
        wall({-3, -2}, {3, -2}), wall({3, -2}, {3, 2}), wall({3, 2}, {-3, 2}),
        wall({-3, 2}, {-3, -2})};
    return Scene(world);
}

/// A wall ahead at x = 2, with this surface, and a plain one behind it at x = 3.
Scene wall_and_wall(Surface surface)
{
    World world;
    world.objects = {wall({2, -50}, {2, 50}, surface), wall({3, -50}, {3, 50})};
    return Scene(world);
}

int beams_at(const LaserScan& scan, double ahead_m, double tolerance_m = 1e-4)
{
    int count = 0;
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i)
        if (std::abs(scan.ranges_m[i] * std::cos(scan.bearing_rad(i)) - ahead_m) < tolerance_m &&
            scan.ranges_m[i] > 0)
            ++count;
    return count;
}
}  // namespace

TEST(SimLaser, AStandingLaserMeasuresTheRoom)
{
    for (const bool clockwise : {true, false})
    {
        auto options = perfect_laser();
        options.clockwise = clockwise;
        Laser laser(options, 1);
        const auto scene = square_room();
        const Pose3 pose{0.5, -0.25, 1, 0, 0, 0.4};
        laser.sweep(scene, 0, pose, 0.1, pose);
        const auto scan = laser.takeScan();
        ASSERT_TRUE(scan.has_value());
        EXPECT_FALSE(laser.takeScan().has_value());
        ASSERT_EQ(scan->ranges_m.size(), 360u);
        EXPECT_NEAR(scan->bearing_rad(0), (clockwise ? 179.5 : -179.5) * pi / 180, 1e-12);
        EXPECT_NEAR(scan->bearing_rad(359), (clockwise ? -179.5 : 179.5) * pi / 180, 1e-12);
        for (std::size_t i = 0; i < 360; ++i)
        {
            const double direction = scan->bearing_rad(i) + 0.4;
            const double x = 0.5 + scan->ranges_m[i] * std::cos(direction);
            const double y = -0.25 + scan->ranges_m[i] * std::sin(direction);
            EXPECT_NEAR(std::max(std::abs(x) / 3, std::abs(y) / 2), 1, 1e-6) << i;  // float
        }
    }
}

TEST(SimLaser, BeamsAreTakenWhereTheVehicleIsAtTheirTime)
{
    // Flies 2 m/s ahead and turns 90 degrees/s; the wall is exact for each beam's own pose.
    Laser laser(perfect_laser(), 1);
    const auto scene = wall_and_wall({});
    const auto pose_at = [](double t) { return Pose3{2 * t, 0, 1, 0, 0, pi / 2 * t}; };
    for (int step = 0; step < 10; ++step)
        laser.sweep(
            scene, 0.01 * step, pose_at(0.01 * step), 0.01 * (step + 1),
            pose_at(0.01 * (step + 1)));
    const auto scan = laser.takeScan();
    ASSERT_TRUE(scan.has_value());
    int met = 0;
    for (std::size_t i = 0; i < 360; ++i)
    {
        if (scan->ranges_m[i] == 0) continue;
        const auto pose = pose_at(static_cast<double>(i) * 0.1 / 360);
        const double ahead = scan->ranges_m[i] * std::cos(scan->bearing_rad(i) + pose.yaw);
        EXPECT_NEAR(pose.x + ahead, 2, 1e-5) << i;
        ++met;
    }
    EXPECT_GT(met, 100);
    // The stamp is the middle beam's, and the truth is that of this time.
    EXPECT_NEAR(scan->time_s, 0.5 * 359 / 3600, 1e-12);
    EXPECT_NEAR(scan->pose_map_vehicle.x, 2 * scan->time_s, 1e-9);
    EXPECT_NEAR(scan->pose_map_vehicle.yaw, pi / 2 * scan->time_s, 1e-9);
}

TEST(SimLaser, StepsOfAnyLengthTakeTheSameBeams)
{
    const auto scene = square_room();
    const auto sweep_in = [&](int steps)
    {
        Laser laser(perfect_laser(), 1);
        for (int i = 0; i < steps; ++i)
            laser.sweep(
                scene, 0.1 * i / steps, {0.1 * i / steps, 0, 1, 0, 0, 0}, 0.1 * (i + 1) / steps,
                {0.1 * (i + 1) / steps, 0, 1, 0, 0, 0});
        return laser.takeScan().value().ranges_m;
    };
    const auto once = sweep_in(1);
    for (const int steps : {2, 7, 50})
    {
        const auto ranges = sweep_in(steps);
        for (std::size_t i = 0; i < 360; ++i) EXPECT_NEAR(ranges[i], once[i], 1e-6);
    }
}

TEST(SimLaser, ATiltedBeamIsLongerByItsElevation)
{
    Laser laser(perfect_laser(), 1);
    World world;
    world.objects = {wall({2, -50}, {2, 50}), wall({-2, -50}, {-2, 50})};
    const double pitch = 5 * pi / 180;  // nose down: ahead beams fall, those behind rise
    const auto scan = laser.snapshot(Scene(world), 0, {0, 0, 1, 0, pitch, 0});
    // Of the beam at half a degree, x shrinks by cos(pitch); the wall is at x = 2.
    const std::size_t ahead = 179, behind = 0;
    EXPECT_NEAR(scan.ranges_m[ahead], 2 / (std::cos(pitch) * std::cos(0.5 * pi / 180)), 1e-6);
    EXPECT_NEAR(scan.ranges_m[behind], scan.ranges_m[ahead], 1e-6);
    // The floor, at 1 m / sin(15 degrees) = 3.86 m, lies before a wall at 5 m.
    World far;
    far.objects = {wall({5, -50}, {5, 50})};
    const auto low = laser.snapshot(Scene(far), 0, {0, 0, 1, 0, 15 * pi / 180, 0});
    EXPECT_NEAR(
        low.ranges_m[ahead], 1 / (std::sin(15 * pi / 180) * std::cos(0.5 * pi / 180)), 1e-5);
}

TEST(SimLaser, ALeftSideUpRollRaisesBeamsToTheLeft)
{
    Laser laser(perfect_laser(), 1);
    World world;
    world.objects = {wall({-50, 2}, {50, 2}), wall({-50, -2}, {50, -2})};
    for (auto& object : world.objects) object.z_min_m = 1;  // only what is above 1 m is there
    const auto scan = laser.snapshot(Scene(world), 0, {0, 0, 1, 0.05, 0, 0});
    int left = 0, right = 0;
    for (std::size_t i = 0; i < 360; ++i)
        if (scan.ranges_m[i] > 0) ++(scan.bearing_rad(i) > 0 ? left : right);
    EXPECT_GT(left, 100);
    EXPECT_EQ(right, 0);
}

TEST(SimLaser, NoiseHasTheWidthThatItIsGiven)
{
    auto options = perfect_laser();
    options.beams = 10000;
    options.noise_m = 0.01;
    options.noise_per_m = 0.005;
    World world;
    world.objects = {{}};
    world.objects[0].shapes_object = {Arc{{0, 0}, 4}};
    Laser laser(options, 3);
    const auto scan = laser.snapshot(Scene(world), 0, {0, 0, 1, 0, 0, 0});
    double sum = 0, squares = 0;
    for (const double range : scan.ranges_m)
    {
        sum += range - 4;
        squares += (range - 4) * (range - 4);
    }
    EXPECT_NEAR(sum / 10000, 0, 4 * 0.03 / 100);           // four standard errors
    EXPECT_NEAR(std::sqrt(squares / 10000), 0.03, 0.001);  // 0.01 + 4 * 0.005
}

TEST(SimLaser, BeamsGoThroughGlassAsOftenAsTheSurfaceSays)
{
    auto options = perfect_laser();
    options.beams = 3600;
    Laser laser(options, 5);
    Surface glass;
    glass.transparency = 0.7;
    const auto scan = laser.snapshot(wall_and_wall(glass), 0, {0, 0, 1, 0, 0, 0});
    const int on_glass = beams_at(scan, 2), behind = beams_at(scan, 3);
    // Within 6 m: acos(2/6) = 70.5 degrees to each side reach the glass, acos(3/6) = 60 the wall.
    EXPECT_NEAR(on_glass, 0.3 * 1410, 5 * std::sqrt(1410 * 0.21));
    EXPECT_NEAR(behind, 0.7 * 1200, 5 * std::sqrt(1200 * 0.21));
}

TEST(SimLaser, AMirrorShowsWhatIsBehindTheVehicle)
{
    Laser laser(perfect_laser(), 5);
    Surface mirror;
    mirror.mirror = 1;
    World world;
    world.objects = {wall({1, -50}, {1, 50}, mirror), wall({-2, -50}, {-2, 50})};
    const auto scan = laser.snapshot(Scene(world), 0, {0, 0, 1, 0, 0, 0});
    // In the mirror at x = 1 the wall at x = -2 appears at x = 4.
    EXPECT_GT(beams_at(scan, 4), 80);
    EXPECT_EQ(beams_at(scan, 1), 0);
}

TEST(SimLaser, ShinyThingsReturnNothing)
{
    Laser laser(perfect_laser(), 5);
    Surface shiny;
    shiny.dropout = 1;
    const auto scan = laser.snapshot(wall_and_wall(shiny), 0, {0, 0, 1, 0, 0, 0});
    for (const auto range : scan.ranges_m) EXPECT_EQ(range, 0);
}

TEST(SimLaser, DropsWhatIsTooNearOrTooFar)
{
    auto options = perfect_laser();
    options.min_range_m = 2.5;
    options.max_range_m = 3.2;
    Laser laser(options, 1);
    const auto scan = laser.snapshot(square_room(), 0, {0, 0, 1, 0, 0, 0});
    int kept = 0;
    for (const auto range : scan.ranges_m)
        if (range > 0)
        {
            ++kept;
            EXPECT_GE(range, 2.5F);
            EXPECT_LE(range, 3.2F);
        }
    EXPECT_GT(kept, 50);
    EXPECT_LT(kept, 200);
}

TEST(SimLaser, TurnsFollowOneAnotherAtTheRate)
{
    auto options = perfect_laser();
    options.rate_hz = 5.5;
    options.field_of_view_deg = 240;
    Laser laser(options, 1);
    const auto scene = square_room();
    const Pose3 pose{0, 0, 1, 0, 0, 0};
    int scans = 0;
    for (int step = 0; step < 1000; ++step)
    {
        laser.sweep(scene, 0.01 * step, pose, 0.01 * (step + 1), pose);
        if (const auto scan = laser.takeScan())
        {
            EXPECT_NEAR(scan->first_beam_s, scans / 5.5, 1e-9);
            EXPECT_NEAR(scan->beam_interval_s, 240.0 / 360 / 5.5 / 360, 1e-12);
            ++scans;
        }
    }
    EXPECT_EQ(scans, 55);  // in 10 s
}

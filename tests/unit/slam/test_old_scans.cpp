// SPDX-License-Identifier: BSD-3-Clause
// Anchor and LoopSearch: a place is left, and found again with an error.
#include <gtest/gtest.h>
#include <near_pose.h>
#include <rtob/map/rtob_map.h>
#include <rtob/slam/anchor.h>
#include <rtob/slam/bent_way.h>
#include <rtob/slam/loop_search.h>
#include <worlds.h>

using namespace rtob;
using namespace rtob::test;

namespace
{
constexpr int kVisitScans = 40;

/// A map of a room that was seen from a few poses, and a long way off since. The vehicle is back in
/// the room, and believes itself `error` off.
struct Loop
{
    World world;
    Pose2 error;
    RtobMap map;
    TravelLog travel;
    double time_s = 0;

    void insert(const Pose2& believed, const Points& points_vehicle)
    {
        map.insertScan(time_s += 0.1, believed, points_vehicle.view());
        travel.inserted(believed);
    }

    [[nodiscard]] Pose2 truth(int step) const
    {
        const Pose2& start = world.pose_map_vehicle;
        return {start.x + 0.01 * step, start.y + 0.005 * step, start.yaw};
    }
    [[nodiscard]] Pose2 believed(int step) const
    {
        const Pose2 pose = truth(step);
        return {pose.x + error.x, pose.y + error.y, pose.yaw + error.yaw};
    }
    [[nodiscard]] Points scan(int step) const { return world.room.scan_vehicle(truth(step)); }

    explicit Loop(World the_world, const Pose2& the_error)
        : world(std::move(the_world)), error(the_error)
    {
        for (int i = 0; i < kVisitScans; ++i) insert(truth(i), scan(i));
        for (int i = 1; i <= 60; ++i) insert({1.0 * i, 50, 0}, scan(0));  // 100 m and more away
    }
    /// The first scans of the second visit, written where the vehicle believes itself.
    void comeBack(int scans)
    {
        for (int i = 0; i < scans; ++i) insert(believed(i), scan(i));
    }
};

IcpResult fit_against_all_scans()
{
    IcpResult fit;
    fit.paired_share = 1;
    fit.mean_squared_error = 0.0004;  // 2 cm
    return fit;
}

/// Of the second visit's third scan, where the vehicle believes itself.
std::optional<IcpResult> align_third_scan(
    Anchor& anchor, const Loop& loop, const DriftOptions& drift = {})
{
    return anchor.align(
        loop.map.view(), loop.travel, Drift(drift), loop.time_s, loop.believed(3),
        fit_against_all_scans(), loop.scan(3));
}

void expect_truth(const Loop& loop, const std::optional<IcpResult>& fit)
{
    ASSERT_TRUE(fit.has_value());
    // Old points are a few centimetres apart.
    EXPECT_THAT(
        apply_correction(loop.believed(3), fit->correction),
        IsNearPose(loop.truth(3), 0.01, 0.005));
}

LoopSearchOptions quick_search()
{
    LoopSearchOptions options;
    options.step_m = 0.01;
    options.local_path_m = 0.5;
    return options;
}

Anchor anchor_with(const AnchorOptions& options = {})
{
    return Anchor(options, IcpOptions(), DensityOptions(), DrawOptions(), ReferenceOptions(), 1);
}
}  // namespace

TEST(Anchor, PullsTheVehicleBackToTheOldScans)
{
    Loop loop(room_with_circle(), {0.15, -0.1, 0.02});
    Anchor anchor = anchor_with();
    const auto fit = align_third_scan(anchor, loop);
    expect_truth(loop, fit);
}

TEST(Anchor, ClosesALargerErrorAfterALongWay)
{
    Loop loop(room_with_circle(), {0.5, -0.3, 0.05});
    Anchor anchor = anchor_with();
    const auto fit = align_third_scan(anchor, loop);
    expect_truth(loop, fit);
}

TEST(Anchor, RefusesWhatNoDriftExplains)
{
    Loop loop(room_with_circle(), {0.5, -0.3, 0.05});
    DriftOptions drift;
    drift.share = 0.001;  // 0.1 m after this way
    Anchor anchor = anchor_with();
    EXPECT_FALSE(align_third_scan(anchor, loop, drift).has_value());
}

TEST(Anchor, SaysNothingWhereOldScansDoNotExplainTheScan)
{
    Loop loop(room_with_circle(), {0, 0, 0});
    Anchor anchor = anchor_with();
    const Points elsewhere = three_cylinders().room.scan_vehicle({0, 0, 1.0});
    EXPECT_FALSE(anchor
                     .align(
                         loop.map.view(), loop.travel, Drift(), loop.time_s, loop.truth(3),
                         fit_against_all_scans(), elsewhere)
                     .has_value());
}

TEST(Anchor, ScansOfThisVisitAreNotOld)
{
    TravelLog travel;
    Loop loop(room_with_circle(), {0, 0, 0});
    for (std::size_t i = 0; i < loop.map.scans().size(); ++i) travel.inserted({0, 0, 0});
    Anchor anchor = anchor_with();
    EXPECT_FALSE(anchor
                     .align(
                         loop.map.view(), travel, Drift(), loop.time_s, loop.believed(3),
                         fit_against_all_scans(), loop.scan(3))
                     .has_value());
}

TEST(LoopSearch, FindsThePlaceTwoMetresOffOnceTwoSearchesAgree)
{
    Loop loop(l_shape(), {2.0, -1.5, 0.1});
    loop.comeBack(30);
    LoopSearch search(quick_search(), IcpOptions(), 1);
    Drift drift;
    const std::size_t old_end = loop.travel.scansBefore(20);
    const Pose2 believed = loop.believed(29);
    EXPECT_FALSE(
        search.search(loop.map.view(), loop.travel, drift, loop.time_s, believed, old_end));
    loop.insert(loop.believed(31), loop.scan(31));
    const auto found =
        search.search(loop.map.view(), loop.travel, drift, loop.time_s, loop.believed(31), old_end);
    ASSERT_TRUE(found.has_value());
    EXPECT_THAT(
        apply_correction(loop.believed(31), found->fit.correction),
        IsNearPose(loop.truth(31), 0.03, 0.01));
}

/// The first find while these steps are driven and written.
std::optional<LoopFound> found_on_the_way(
    LoopSearch& search, Loop& loop, int first_step, int last_step)
{
    std::optional<LoopFound> found;
    for (int i = first_step; i <= last_step && !found; ++i)
    {
        loop.insert(loop.believed(i), loop.scan(i));
        found = search.search(
            loop.map.view(), loop.travel, Drift(), loop.time_s, loop.believed(i), kVisitScans);
    }
    return found;
}

TEST(LoopSearch, RestsOnTheOldScansOfThePlace)
{
    Loop loop(l_shape(), {2.0, -1.5, 0.1});
    loop.comeBack(30);
    LoopSearch search(quick_search(), IcpOptions(), 1);
    const auto found = found_on_the_way(search, loop, 30, 32);
    ASSERT_TRUE(found.has_value());
    EXPECT_GT(found->old_scan, 10u);
    EXPECT_LT(found->old_scan, static_cast<std::size_t>(kVisitScans));
}

TEST(LoopSearch, FindsTheErrorOnceOnlyAsTheWayIsBent)
{
    // Killian, seeds 3 and 7: a way that was left where it was held the place's error once more.
    Loop loop(l_shape(), {2.0, -1.5, 0.1});
    loop.comeBack(30);
    LoopSearch search(quick_search(), IcpOptions(), 1);
    const auto found = found_on_the_way(search, loop, 30, 32);
    ASSERT_TRUE(found.has_value());
    const Pose2 end = loop.believed(31);
    const Pose2 end_now = apply_correction(end, found->fit.correction);
    std::vector<Pose2> poses;
    bend_way(loop.map.scans(), loop.travel, found->old_scan + 1, end, end_now, poses);
    loop.map.moveScans(found->old_scan + 1, poses);
    loop.travel.moved(poses.back());

    loop.error = {0, 0, 0};  // the vehicle goes on from where it was found
    const auto found_again = found_on_the_way(search, loop, 32, 36);
    ASSERT_TRUE(found_again.has_value());
    EXPECT_THAT(found_again->fit.correction, IsNearPose(Pose2{}, 0.05, 0.01));
}

TEST(LoopSearch, WaitsWhileTheVehicleIsAnchored)
{
    Loop loop(l_shape(), {2.0, -1.5, 0.1});
    loop.comeBack(30);
    LoopSearchOptions options;
    options.step_m = 0.01;
    LoopSearch search(options, IcpOptions(), 1);
    Drift drift;
    IcpResult fit;
    fit.pairs = 100;
    fit.information.diagonal() << 50, 50, 100;  // half of the pairs hold each direction
    drift.held(loop.travel, fit);
    for (int i = 31; i < 34; ++i)
    {
        loop.insert(loop.believed(i), loop.scan(i));
        EXPECT_FALSE(search.search(
            loop.map.view(), loop.travel, drift, loop.time_s, loop.believed(i),
            loop.travel.scansBefore(20)));
    }
}

TEST(LoopSearch, ACorridorIsNoAnchor)
{
    Loop loop(l_shape(), {2.0, -1.5, 0.1});
    loop.comeBack(30);
    LoopSearch search(quick_search(), IcpOptions(), 1);
    Drift drift;
    IcpResult corridor;
    corridor.pairs = 100;
    corridor.information.diagonal() << 0.5, 99, 100;  // nothing holds x
    drift.held(loop.travel, corridor);
    const std::size_t old_end = loop.travel.scansBefore(20);
    bool found = false;
    for (int i = 31; i < 34; ++i)
    {
        loop.insert(loop.believed(i), loop.scan(i));
        found |=
            search
                .search(loop.map.view(), loop.travel, drift, loop.time_s, loop.believed(i), old_end)
                .has_value();
    }
    EXPECT_TRUE(found);
}

// SPDX-License-Identifier: BSD-3-Clause
// Draw and alignment allocate nothing once warm: counted with a replaced operator new.
#include <allocation_count.h>
#include <gtest/gtest.h>
#include <rtob/core/enum_names.h>
#include <rtob/core/icp.h>
#include <test_map.h>
#include <worlds.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

using namespace rtob;
using test::AllocationCount;

namespace
{
/// A vehicle that drives back and forth past a room's corner; each scan sees the whole room.
test::TestMap driven_map(int scans)
{
    const auto world = test::worlds()[0];
    test::TestMap map;
    for (int k = 0; k < scans; ++k)
    {
        const Pose2 pose{1.6 + std::sin(0.05 * k), 1.2, 0.01 * k};
        const Points points_map = test::moved(world.room.scan_vehicle(pose), pose);
        map.add(
            0.1 * k, pose, static_cast<std::uint32_t>(points_map.size()),
            [&](std::uint32_t i) { return std::pair(points_map.x[i], points_map.y[i]); });
    }
    return map;
}

/// One scan against the map, over and over, at the places where a vehicle may be.
int allocations_once_warm(
    const DensityOptions& options, DrawMode mode, const IcpOptions& icp_options)
{
    static const test::TestMap map = driven_map(400);
    const TimeDensity density(options);
    ReferenceDraw draw({3600, mode});
    Icp icp(icp_options);
    Random random(1);
    Reference reference;
    const auto step = [&](int i)
    {
        const Moment now{40 + 0.1 * i, 1.6 + std::sin(0.3 * i), 1.2};
        std::optional<Box> gate;
        if (i % 2 == 0) gate = Box::around(now.x, now.y, 1.0 + 0.2 * (i % 5));
        draw.draw(map.view(), density, now, gate, random, reference);
        const PointsView scan{
            reference.points.x.data(), reference.points.y.data(),
            std::min<std::size_t>(360, reference.points.size())};
        (void)icp.align(scan, reference.points.view());
    };
    step(0);
    step(1);
    const AllocationCount count;
    for (int i = 2; i < 12; ++i) step(i);
    return count.soFar();
}
}  // namespace

TEST(Allocations, AreCounted)
{
    if (RTOB_SANITIZED) GTEST_SKIP() << "the sanitizer has its own operator new";
    const AllocationCount count;
    auto* one = new std::vector<int>(1);
    delete one;
    EXPECT_EQ(count.soFar(), 2);
    std::vector<int> some(100);
    some.resize(1000);
    EXPECT_EQ(count.soFar(), 4);
}

TEST(Allocations, NoneInDrawAndAlignmentOnceWarm)
{
    if (RTOB_SANITIZED) GTEST_SKIP() << "the sanitizer has its own operator new";
    const IcpOptions point = test::paper_icp_options();
    IcpOptions line = point;
    line.metric = IcpMetric::PointToLine;
    for (const auto name :
         {Density::Uniform, Density::Interval, Density::Window, Density::Forgetting,
          Density::Revisit})
        for (const auto mode : {DrawMode::Independent, DrawMode::Stratified})
            for (const double forgetting_s : {0.0, 20.0})
            {
                DensityOptions options;
                options.density = name;
                options.vicinity_m = 0.5;
                options.forgetting_s =
                    name == Density::Forgetting && forgetting_s == 0 ? 10 : forgetting_s;
                EXPECT_EQ(allocations_once_warm(options, mode, point), 0) << name_of(name);
                EXPECT_EQ(allocations_once_warm(options, mode, line), 0) << name_of(name);
            }
}

// SPDX-License-Identifier: BSD-3-Clause
// process() allocates nothing once warm: counted with a replaced operator new.
#include <allocation_count.h>
#include <gtest/gtest.h>
#include <rtob/core/enum_names.h>
#include <rtob/slam/slam.h>

#include <vector>

#include "drive_log.h"
#include "worlds.h"

using namespace rtob;

namespace
{
/// Scans and odometry, made before anything is counted.
struct Log
{
    std::vector<mrpt::obs::CObservation2DRangeScan::Ptr> scans;
    std::vector<mrpt::obs::CObservationOdometry::Ptr> odometry;
};

/// Laps of 63 scans.
const Log& laps()
{
    static const Log log = []
    {
        Log made;
        for (int k = 0; k < 630; ++k)
        {
            made.scans.push_back(test::scan_on_circle(k));
            made.odometry.push_back(test::odometry_on_circle(k));
        }
        return made;
    }();
    return log;
}

/// Of another place: no map of the laps explains it.
mrpt::obs::CObservation2DRangeScan::Ptr scan_elsewhere(std::size_t k)
{
    std::vector<test::Wall> walls;
    test::add_circle(walls, 0, 0, 5);
    return mrpt::obs::CObservation2DRangeScan::Create(test::scan_observation(
        test::Room(walls), {}, test::drive_start_s + 0.1 * static_cast<double>(k),
        test::mrpt_laser()));
}

/// @return the allocations of scans [warm, all) and how many of them were tracked.
std::pair<int, int> count_allocations(Slam& slam, const Log& log, std::size_t warm)
{
    int tracked = 0, allocations = 0;
    for (std::size_t k = 0; k < log.scans.size(); ++k)
    {
        const test::AllocationCount count;
        slam.observe(*log.odometry[k]);
        const bool tracks = slam.process(*log.scans[k]).state == TrackingState::Tracking;
        if (k < warm) continue;
        allocations += count.soFar();
        tracked += tracks;
    }
    return {allocations, tracked};
}
}  // namespace

// MRPT's own allocator holds x, y and z of the map and is not seen here: RtobMap's test looks at
// their capacity instead.
TEST(SlamAllocations, NoneOnceWarm)
{
    if (RTOB_SANITIZED) GTEST_SKIP() << "sanitizers replace operator new themselves";
    for (const auto density :
         {Density::Uniform, Density::Window, Density::Forgetting, Density::Revisit})
    {
        SlamOptions options;
        options.density.density = density;
        options.density.forgetting_s = density == Density::Forgetting ? 10 : 0;
        options.anchor.min_path_m = 3;  // one lap: the anchor is at work from the second on
        Log log = laps();
        log.scans[150] = scan_elsewhere(150);  // a search is part of the warm-up
        Slam slam(options);
        const auto [allocations, tracked] = count_allocations(slam, log, 200);
        EXPECT_EQ(allocations, 0) << name_of(density);
        EXPECT_EQ(tracked, 430) << name_of(density);
    }
}

TEST(SlamAllocations, NoneWhileLostAndSearchingOnceWarm)
{
    if (RTOB_SANITIZED) GTEST_SKIP() << "sanitizers replace operator new themselves";
    Log log = laps();
    for (std::size_t k = 100; k < log.scans.size(); ++k)
        if (k % 60 < 30) log.scans[k] = scan_elsewhere(k);  // carried away and put back, often
    SlamOptions options;
    options.anchor.min_path_m = 3;
    Slam slam(options);
    const auto [allocations, tracked] = count_allocations(slam, log, 300);
    EXPECT_EQ(allocations, 0);
    EXPECT_GT(tracked, 30);
    EXPECT_LT(tracked, 300);
}

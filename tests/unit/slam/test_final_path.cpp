// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <near_pose.h>
#include <rtob/slam/final_path.h>

#include <limits>

using namespace rtob;
using rtob::test::IsNearPose;

namespace
{
ScanReport report_at(double time_s, const Pose2& pose, bool inserted)
{
    ScanReport report;
    report.stamp_s = 1000 + time_s;
    report.map_time_s = time_s;
    report.pose_map_vehicle = pose;
    report.inserted = inserted;
    return report;
}

/// Scans at x = 0, 1, 2, 3 m, the first and the third of them in the map.
struct FewScans
{
    FinalPath path;
    ScanTable scans;

    FewScans()
    {
        for (int i = 0; i < 4; ++i)
        {
            const Pose2 pose{1.0 * i, 0, 0};
            path.add(report_at(i, pose, i % 2 == 0));
            if (i % 2 == 0) scans.append(i, pose, 1);
        }
    }
};
}  // namespace

TEST(FinalPath, IsThePathThatWasToldWhereTheMapStayed)
{
    const FewScans run;
    const auto path = run.path.in(run.scans);
    ASSERT_EQ(path.size(), 4u);
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(path[i].time_s, 1000 + i);
        EXPECT_THAT(path[i].pose, IsNearPose(Pose2({1.0 * i, 0, 0}), 1e-12, 1e-12));
    }
}

TEST(FinalPath, GoesWithTheScansThatWereMoved)
{
    FewScans run;
    run.scans.move(1, {2, 5, 1.57079632679});  // the third, turned to the left
    const auto path = run.path.in(run.scans);
    EXPECT_THAT(path[1].pose, IsNearPose(Pose2({1, 0, 0}), 1e-9, 1e-9));
    EXPECT_THAT(path[2].pose, IsNearPose(Pose2({2, 5, 1.57079632679}), 1e-9, 1e-9));
    EXPECT_THAT(path[3].pose, IsNearPose(Pose2({2, 6, 1.57079632679}), 1e-9, 1e-9));
}

TEST(FinalPath, AForgottenScanGoesWithTheOneBefore)
{
    FewScans run;
    run.scans.move(0, {0, 1, 0});
    run.scans.keepOnly({1, 0});
    for (const auto& stamped : run.path.in(run.scans)) EXPECT_NEAR(stamped.pose.y, 1, 1e-12);
}

TEST(FinalPath, ScansThatShareATimeAreToldApart)
{
    // Intel's log repeats its stamps.
    FinalPath path;
    ScanTable scans;
    for (const double x : {0.0, 1.0, 2.0})
    {
        path.add(report_at(7, {x, 0, x}, true));
        scans.append(7, {x, 0, x}, 1);
    }
    const auto poses = path.in(scans);
    for (int i = 0; i < 3; ++i)
        EXPECT_THAT(poses[i].pose, IsNearPose(Pose2({1.0 * i, 0, 1.0 * i}), 1e-9, 1e-9)) << i;
}

TEST(FinalPath, AStampThatIsNoNumberIsZero)
{
    FinalPath path;
    ScanReport report;
    report.stamp_s = std::numeric_limits<double>::quiet_NaN();
    path.add(report);
    EXPECT_EQ(path.in(ScanTable()).at(0).time_s, 0);
}

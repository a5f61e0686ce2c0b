// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/continuity.h>

#include "house.h"

namespace rtob
{
namespace
{
Points scan_at(int scan)
{
    return test::house().scan_vehicle(test::pose_in_house(scan));
}

TEST(Continuity, AScanOfADriveFollowsTheLastOne)
{
    Continuity continuity({});
    for (int k = 0; k < test::house_lap_scans; k += 20)
    {
        continuity.tracked("laser", test::pose_in_house(k), scan_at(k));
        EXPECT_GT(continuity.agreement("laser", test::pose_in_house(k + 2), scan_at(k + 2)), 0.85)
            << k;
    }
}

TEST(Continuity, OneOfAnotherRoomDoesNot)
{
    Continuity continuity({});
    continuity.tracked("laser", test::pose_in_house(0), scan_at(0));
    std::vector<test::Wall> walls;
    test::add_circle(walls, 0, 0, 5);
    EXPECT_LT(
        continuity.agreement("laser", test::pose_in_house(0), test::Room(walls).scan_vehicle({})),
        0.5);
}

TEST(Continuity, WithNothingToCompareWithNothingSpeaksAgainstIt)
{
    Continuity continuity({});
    EXPECT_EQ(continuity.agreement("laser", {}, scan_at(0)), 1);
    continuity.tracked("laser", test::pose_in_house(0), scan_at(0));
    EXPECT_EQ(continuity.agreement("another", {}, scan_at(100)), 1);
    continuity.clear();
    EXPECT_EQ(continuity.agreement("laser", {}, scan_at(100)), 1);
}
}  // namespace
}  // namespace rtob

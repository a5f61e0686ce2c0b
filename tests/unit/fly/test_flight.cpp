// SPDX-License-Identifier: BSD-3-Clause
#include <campaign.h>
#include <gtest/gtest.h>
#include <tally_text.h>

#include <cmath>

using namespace rtob;
using namespace rtob::fly;

namespace
{
CampaignPlan short_plan(const std::string& avoider)
{
    CampaignPlan plan;
    plan.avoider = avoider;
    plan.worlds = fly_world_names();
    plan.flights = 24;  // each world with each pilot, with the longest latency always and not
    plan.duration_s = 15;
    return plan;
}

CampaignTally flown(const CampaignPlan& plan)
{
    return run_campaign(plan, [](std::uint64_t) {});
}
}  // namespace

TEST(Flight, TheGuardTouchesNothing)
{
    const CampaignTally tally = flown(short_plan("guard"));
    EXPECT_EQ(tally.flights, 24u);
    EXPECT_EQ(tally.contacts, 0u) << tally_notes(tally);
    EXPECT_GT(tally.flown_m, 24 * 2.0);  // it does fly
}

// What is out of view was in view: the memory.
TEST(Flight, TheGuardTouchesNothingThatItsLaserDoesNotSeeAnyMore)
{
    CampaignPlan plan = short_plan("guard");
    plan.field_of_view_deg = 270;
    const CampaignTally tally = flown(plan);
    EXPECT_EQ(tally.contacts, 0u) << tally_notes(tally);
    EXPECT_GT(tally.flown_m, 24 * 1.0);
}

// Else the flight above would show nothing.
TEST(Flight, ThePilotAloneTouchesWalls)
{
    EXPECT_GT(flown(short_plan("none")).flights_with_contact, 12u);
}

TEST(Flight, PassesDoorsWithTenCentimetresToSpare)
{
    const DoorTally doors = try_doors("guard", 6);
    EXPECT_EQ(doors.passed, doors.tries);
    EXPECT_LE(doors.flights.side_changes, 6 * 4u);  // it aims, and does not swing
}

// The wish leads 30 degrees into a wall of 12 m: the vehicle goes along it, all the way, and does
// not swing from side to side.
TEST(Flight, SlidesAlongAWall)
{
    FlyWorld hall;
    hall.name = hall.world.name = "hall";
    sim::Object wall;
    wall.shapes_object = {
        sim::Segment{{0, 0}, {12, 0}}, sim::Segment{{12, 0}, {12, 6}},
        sim::Segment{{12, 6}, {0, 6}}, sim::Segment{{0, 6}, {0, 0}}};
    hall.world.objects.push_back(wall);
    hall.area = {0, 0, 12, 6};
    hall.route_map = {{100, 4 + 100 * std::tan(M_PI / 6)}};
    FlightSetup setup;
    setup.pilot = PilotKind::Straight;
    setup.duration_s = 20;
    setup.limits = fly_limits();
    setup.options = fly_options();
    setup.start_map = Pose2{1, 4, 0};
    const FlightResult result = rtob::fly::fly(hall, setup);
    EXPECT_EQ(result.contacts, 0);
    EXPECT_GT(result.end_map.x, 10);
    EXPECT_LE(result.side_changes, 2);
}

TEST(Flight, IsTheSameEachTimeAndWithMoreThreads)
{
    CampaignPlan plan = short_plan("guard");
    plan.flights = 4;
    plan.duration_s = 5;
    const CampaignTally one = flown(plan);
    plan.jobs = 2;
    const CampaignTally two = flown(plan);
    EXPECT_EQ(one.least_gap_m, two.least_gap_m);
    EXPECT_EQ(one.decisions, two.decisions);
    EXPECT_EQ(one.reasons, two.reasons);
}

TEST(Flight, ItsNumberDecidesAllOfIt)
{
    const CampaignPlan plan = short_plan("guard");
    EXPECT_EQ(numbered_flight(plan, 0).world, "room");
    EXPECT_EQ(numbered_flight(plan, 5).world, "garage");
    EXPECT_EQ(numbered_flight(plan, 5).setup.pilot, PilotKind::Random);
    EXPECT_TRUE(numbered_flight(plan, 5).setup.hardship.always_latest);
    EXPECT_FALSE(numbered_flight(plan, 17).setup.hardship.always_latest);
}

TEST(Flight, UnknownNamesAreRefusedWithTheKnownOnes)
{
    EXPECT_THROW(static_cast<void>(make_fly_world("rom")), std::invalid_argument);
    try
    {
        static_cast<void>(make_avoider("px5", fly_limits(), fly_options()));
        FAIL();
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_NE(std::string(error.what()).find("px4"), std::string::npos);
    }
}

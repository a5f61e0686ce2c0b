// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/drivers/revolution_builder.h>

#include <vector>

namespace rtob
{
namespace
{
RplidarBeam beam_at(double deg, bool starts, double time_s = 0)
{
    RplidarBeam beam;
    beam.bearing_deg = beam.shaft_deg = deg;
    beam.range_m = 1;
    beam.starts = starts;
    beam.time_s = time_s;
    return beam;
}

/// Turns of 360 beams, a degree and a millisecond apart, without those of the list.
std::vector<RplidarRevolution> feed(
    RevolutionBuilder& builder, int turns, const std::vector<int>& missing = {})
{
    std::vector<RplidarRevolution> ended;
    for (int i = 0; i <= 360 * turns; ++i)
    {
        if (std::find(missing.begin(), missing.end(), i) != missing.end()) continue;
        if (auto whole = builder.add(beam_at(i % 360, i % 360 == 0, 1e-3 * i)))
            ended.push_back(std::move(*whole));
    }
    return ended;
}

std::vector<int> from_to(int first, int last)
{
    std::vector<int> list;
    for (int i = first; i <= last; ++i) list.push_back(i);
    return list;
}

TEST(RevolutionBuilder, GivesWholeTurnsWithTheirTimes)
{
    RevolutionBuilder builder;
    const auto turns = feed(builder, 3);
    ASSERT_EQ(3u, turns.size());
    EXPECT_EQ(360u, turns[1].beams.size());
    EXPECT_NEAR(0.360, turns[1].start_s, 1e-12);
    EXPECT_NEAR(0.360, turns[1].sweep_s, 1e-12);
    EXPECT_EQ(3u, builder.revolutions());
    EXPECT_EQ(0u, builder.partial());
}

TEST(RevolutionBuilder, WaitsForTheFirstStart)
{
    RevolutionBuilder builder;
    for (int deg = 100; deg < 360; ++deg) EXPECT_FALSE(builder.add(beam_at(deg, false)));
    EXPECT_EQ(1u, feed(builder, 1).size());
}

TEST(RevolutionBuilder, KeepsATurnWithANarrowHole)
{
    RevolutionBuilder builder;
    const auto turns = feed(builder, 1, from_to(100, 108));  // 99 to 109: 10 degrees
    ASSERT_EQ(1u, turns.size());
    EXPECT_EQ(351u, turns[0].beams.size());
}

TEST(RevolutionBuilder, DropsATurnWithAWideHole)
{
    RevolutionBuilder builder;
    EXPECT_EQ(2u, feed(builder, 3, from_to(360 + 100, 360 + 109)).size());
    EXPECT_EQ(1u, builder.partial());
}

TEST(RevolutionBuilder, DropsATurnWhoseStartIsMissing)
{
    RevolutionBuilder builder;
    EXPECT_EQ(2u, feed(builder, 4, {720}).size());  // the 2nd and 3rd turn are one of 720 degrees
    EXPECT_EQ(1u, builder.partial());
}

TEST(RevolutionBuilder, DropsATurnThatEndsEarly)
{
    RevolutionBuilder builder;
    EXPECT_EQ(2u, feed(builder, 3, from_to(360 + 200, 719)).size());
    EXPECT_EQ(1u, builder.partial());
}

TEST(RevolutionBuilder, LeavesOutAStrayBeam)
{
    RevolutionBuilder builder;
    for (int deg = 0; deg < 360; ++deg)
    {
        static_cast<void>(builder.add(beam_at(deg, deg == 0)));
        if (deg == 77) static_cast<void>(builder.add(beam_at(250, false)));
        if (deg == 80) static_cast<void>(builder.add(beam_at(81, true)));
    }
    const auto whole = builder.add(beam_at(0, true));
    ASSERT_TRUE(whole);
    EXPECT_EQ(360u, whole->beams.size());
    EXPECT_EQ(2u, builder.strayBeams());
}

TEST(RevolutionBuilder, AcceptsBearingsThatStepBackALittle)
{
    RevolutionBuilder builder;
    for (int deg = 0; deg < 360; deg += 2)
    {
        static_cast<void>(builder.add(beam_at(deg + 1, deg == 0)));
        static_cast<void>(builder.add(beam_at(deg, false)));
    }
    EXPECT_TRUE(builder.add(beam_at(0.5, true)));
}

TEST(RevolutionBuilder, DoesNotGrowWithoutAStart)
{
    RevolutionBuilder builder;
    static_cast<void>(builder.add(beam_at(0, true)));
    for (int i = 0; i < 100000; ++i) ASSERT_FALSE(builder.add(beam_at(i % 360, false)));
    EXPECT_EQ(1u, builder.partial());
}
}  // namespace
}  // namespace rtob

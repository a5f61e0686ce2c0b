// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/random.h>
#include <rtob/drivers/beam_grid.h>

#include <cmath>

namespace rtob
{
namespace
{
/// Beams at even steps from `first_deg` on; a range says which bearing it was taken at.
RplidarRevolution revolution(std::size_t beams, double first_deg)
{
    RplidarRevolution turn;
    for (std::size_t i = 0; i < beams; ++i)
    {
        RplidarBeam beam;
        beam.bearing_deg =
            std::fmod(first_deg + 360.0 * static_cast<double>(i) / static_cast<double>(beams), 360);
        beam.range_m = static_cast<float>(1 + beam.bearing_deg / 100);
        turn.beams.push_back(beam);
    }
    return turn;
}

TEST(BeamGrid, MovesNoBeamByMoreThanHalfItsDistanceToTheNext)
{
    Random random(3);
    for (const std::size_t beams : {180U, 361U, 799U, 1450U, 3200U})
    {
        BeamGrid grid;
        const double distance_deg = 360.0 / static_cast<double>(beams);
        for (int i = 0; i < 20; ++i)
        {
            const auto gridded = grid.grid(revolution(beams, 360 * random.uniform()));
            ASSERT_LE(gridded.stepDeg(), distance_deg);
            for (std::size_t k = 0; k < gridded.ranges_m.size(); ++k)
            {
                if (gridded.ranges_m[k] == 0) continue;
                const double taken_deg = 100 * (gridded.ranges_m[k] - 1.0);
                const double shown_deg = (static_cast<double>(k) + 0.5) * gridded.stepDeg();
                // 1e-4: ranges are floats
                EXPECT_LE(std::abs(taken_deg - shown_deg), 0.5 * distance_deg + 1e-4);
            }
        }
    }
}

TEST(BeamGrid, KeepsItsSizeWhileTheSpeedWavers)
{
    BeamGrid grid;
    const auto size = grid.grid(revolution(400, 0)).ranges_m.size();
    for (const std::size_t beams : {396U, 404U, 390U, 408U, 380U})
        EXPECT_EQ(size, grid.grid(revolution(beams, 0)).ranges_m.size()) << beams;
}

TEST(BeamGrid, FollowsALastingChangeOfSpeed)
{
    BeamGrid grid;
    static_cast<void>(grid.grid(revolution(800, 0)));
    for (int i = 0; i < 12; ++i) static_cast<void>(grid.grid(revolution(400, 0)));
    EXPECT_LT(grid.grid(revolution(400, 0)).ranges_m.size(), 420u);
    EXPECT_GT(grid.grid(revolution(1600, 0)).ranges_m.size(), 1600u);
}

TEST(BeamGrid, TakesTheBeamInTheMiddleOfAStep)
{
    BeamGrid grid(360);
    RplidarRevolution turn;
    const auto add = [&](double bearing_deg, float range_m)
    {
        RplidarBeam beam;
        beam.bearing_deg = bearing_deg;
        beam.range_m = range_m;
        turn.beams.push_back(beam);
    };
    add(10.1, 1);
    add(10.45, 2);
    add(10.9, 3);
    add(20.5, 0);  // nothing seen
    add(20.9, 4);
    add(359.9999, 5);
    const auto gridded = grid.grid(turn);
    EXPECT_EQ(2.0f, gridded.ranges_m[10]);
    EXPECT_EQ(4.0f, gridded.ranges_m[20]);
    EXPECT_EQ(5.0f, gridded.ranges_m[359]);
    EXPECT_EQ(0.0f, gridded.ranges_m[11]);
}
}  // namespace
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/core/random.h>
#include <rtob/io/no_return.h>

namespace rtob::test
{
namespace
{
constexpr std::size_t kBeams = 180;

/// Ranges between 1 and 10 m, from a log that does not tell the maximum range.
mrpt::obs::CObservation2DRangeScan room_scan(Random& random)
{
    mrpt::obs::CObservation2DRangeScan scan;
    scan.maxRange = 1000;
    scan.resizeScan(kBeams);
    for (std::size_t i = 0; i < kBeams; ++i)
    {
        scan.setScanRange(i, static_cast<float>(1 + 9 * random.uniform()));
        scan.setScanRangeValidity(i, true);
    }
    return scan;
}

/// A hundred scans of the room, each changed by `change(scan, number)`.
template <class Change>
NoReturnFinder finder_after(Change&& change)
{
    NoReturnFinder finder;
    Random random(7);
    for (int k = 0; k < 100; ++k)
    {
        auto scan = room_scan(random);
        change(scan, k);
        finder.add(scan);
    }
    return finder;
}

TEST(NoReturnFinder, FindsTheNumberThatStandsInForIt)
{
    const auto found =
        finder_after([](auto& scan, int k) { scan.setScanRange(std::size_t(k) % kBeams, 81.83F); })
            .found();
    ASSERT_TRUE(found);
    EXPECT_FLOAT_EQ(found->from_m, 81.83F);
    EXPECT_EQ(found->beams, 100U);
}

/// A scanner's other codes (dazzled, ...) lie a few centimetres beside.
TEST(NoReturnFinder, TakesItsNeighboursIn)
{
    const auto found = finder_after(
                           [](auto& scan, int k)
                           {
                               scan.setScanRange(std::size_t(k) % kBeams, 81.91F);
                               if (k % 10 == 0) scan.setScanRange(99, 81.83F);
                           })
                           .found();
    ASSERT_TRUE(found);
    EXPECT_FLOAT_EQ(found->from_m, 81.83F);
    EXPECT_EQ(found->beams, 110U);
}

TEST(NoReturnFinder, IsNotFooledByAFarWall)
{
    // Ten beams of every scan, always the same ones, as of a vehicle that stands in a corridor.
    const auto found = finder_after(
                           [](auto& scan, int)
                           {
                               for (std::size_t i = 85; i < 95; ++i) scan.setScanRange(i, 20.0F);
                           })
                           .found();
    EXPECT_FALSE(found);
}

TEST(NoReturnFinder, NeedsMoreThanAFewBeams)
{
    EXPECT_FALSE(finder_after(
                     [](auto& scan, int k)
                     {
                         if (k < 10) scan.setScanRange(std::size_t(k) * 18, 81.83F);
                     })
                     .found());
    EXPECT_FALSE(finder_after([](auto&, int) {}).found());
    EXPECT_FALSE(NoReturnFinder().found());
}

TEST(WithMaxRange, MarksBeamsFromThereOnAndKeepsTheirRanges)
{
    Random random(7);
    auto scan = room_scan(random);
    scan.setScanRange(3, 81.83F);
    scan.setScanRange(4, 81.82F);
    const auto limited = with_max_range(scan, 81.83F);
    EXPECT_FLOAT_EQ(limited->maxRange, 81.83F);
    EXPECT_FALSE(limited->getScanRangeValidity(3));
    EXPECT_FLOAT_EQ(limited->getScanRange(3), 81.83F);
    EXPECT_TRUE(limited->getScanRangeValidity(4));
    EXPECT_TRUE(lacks_max_range(scan));
    EXPECT_FALSE(lacks_max_range(*limited));
}
}  // namespace
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#include <check_drive.h>
#include <gmock/gmock.h>
#include <rtob/check/range_check.h>

#include <limits>

namespace rtob::test
{
namespace
{
/// 100 scans of 100 beams between 1 and 5 m, evenly.
class RangeCheckTest : public testing::Test
{
 protected:
    static constexpr int scans = 100;
    static constexpr std::size_t beams = 100;

    template <class Spoil>
    void check(Spoil&& spoil)
    {
        for (int k = 0; k < scans; ++k)
        {
            const auto scan = scan_of(beams, 1, true, 0.1 * k);
            for (std::size_t i = 0; i < beams; ++i)
                scan->setScanRange(
                    i, 1 + 4 * static_cast<float>((i * 37 + std::size_t(k) * 11) % beams) / 100);
            spoil(*scan, k);
            check_.add(*scan);
        }
        check_.report(report_);
    }

    RangeCheck check_;
    CheckReport report_;
};

TEST_F(RangeCheckTest, PlainRangesAreFine)
{
    check([](auto&, int) {});
    EXPECT_EQ(troubles(report_), "");
    EXPECT_FALSE(check_.farSentinel());
    EXPECT_EQ(check_.usefulRange(), 40);  // the default
    EXPECT_NEAR(figure(report_, "ranges.reach", "median_m"), 3, 0.05);
    EXPECT_NEAR(figure(report_, "ranges.reach", "p99_m"), 4.96, 0.05);
}

TEST_F(RangeCheckTest, ABandOfValuesIsOneSentinel)
{
    check(
        [](auto& scan, int k)
        {
            for (std::size_t i = 0; i < beams; i += 9)
                scan.setScanRange(i, k % 4 == 0 ? 51.1F : 51.05F);
        });
    const auto sentinel = check_.farSentinel();
    ASSERT_TRUE(sentinel);
    EXPECT_NEAR(sentinel->low_m, 51.05, 0.011);
    EXPECT_NEAR(sentinel->high_m, 51.10, 0.011);
    EXPECT_NEAR(sentinel->usual_m, 51.05, 0.011);
    EXPECT_EQ(sentinel->count, 12u * scans);
    EXPECT_EQ(sentinel->valid, 12u * scans);
    EXPECT_NEAR(sentinel->reach_m, 4.96, 0.011);
    EXPECT_EQ(troubles(report_), "WARN ranges.no_return");
}

TEST_F(RangeCheckTest, AFewStraysBeyondDoNotHideIt)
{
    check(
        [](auto& scan, int k)
        {
            for (std::size_t i = 0; i < beams; i += 9) scan.setScanRange(i, 30);
            if (k < 5) scan.setScanRange(50, 60.0F + static_cast<float>(k));
        });
    ASSERT_TRUE(check_.farSentinel());
    EXPECT_NEAR(check_.farSentinel()->usual_m, 30, 0.011);
    EXPECT_LT(check_.usefulRange(), 30);
    EXPECT_GT(check_.usefulRange(), 5);
}

TEST_F(RangeCheckTest, AWallAcrossACorridorIsNone)
{
    // Far, always at the same range, but seen in four beams side by side only.
    check(
        [](auto& scan, int)
        {
            for (std::size_t i = 48; i < 52; ++i) scan.setScanRange(i, 20);
        });
    EXPECT_FALSE(check_.farSentinel());
}

TEST_F(RangeCheckTest, RangesThatThinOutWithDistanceAreNone)
{
    check(
        [](auto& scan, int k)
        {
            for (std::size_t i = 0; i < beams; i += 3)
                scan.setScanRange(
                    i, 5 + static_cast<float>((i * 7 + std::size_t(k) * 13) % 1000) / 100);
        });
    EXPECT_FALSE(check_.farSentinel());
}

TEST_F(RangeCheckTest, ZerosAreCountedAndWarnOnlyWhenCalledValid)
{
    check(
        [](auto& scan, int)
        {
            scan.setScanRange(7, 0);
            scan.setScanRangeValidity(7, false);
        });
    EXPECT_EQ(troubles(report_), "");
    EXPECT_EQ(figure(report_, "ranges.zero", "zero"), scans);
    EXPECT_NEAR(figure(report_, "ranges.share", "no_return_share"), 0.01, 1e-9);
    check([](auto& scan, int) { scan.setScanRange(7, 0); });
    EXPECT_THAT(troubles(report_), testing::HasSubstr("WARN ranges.zero"));
}

TEST_F(RangeCheckTest, NaNNegativeAndHugeRangesAreCounted)
{
    check(
        [](auto& scan, int)
        {
            scan.setScanRange(1, std::numeric_limits<float>::quiet_NaN());
            scan.setScanRange(2, std::numeric_limits<float>::infinity());
            scan.setScanRange(3, -1);
            scan.setScanRange(4, 1e6F);
        });
    EXPECT_EQ(figure(report_, "ranges.zero", "not_a_number"), 2 * scans);
    EXPECT_EQ(figure(report_, "ranges.zero", "negative"), scans);
    EXPECT_EQ(figure(report_, "ranges.zero", "beyond_655_m"), scans);
}

TEST_F(RangeCheckTest, CodesOfErrorsAreNotRanges)
{
    check([](auto& scan, int k) { scan.setScanRange(7, k % 2 == 0 ? 0.007F : 0.001F); });
    EXPECT_EQ(troubles(report_), "WARN ranges.codes");
    EXPECT_NEAR(figure(report_, "ranges.codes", "smallest_m"), 0.001, 1e-6);
    EXPECT_NEAR(figure(report_, "ranges.codes", "largest_m"), 0.007, 1e-6);
}

TEST_F(RangeCheckTest, MillimetresFail)
{
    check(
        [](auto& scan, int)
        {
            for (std::size_t i = 0; i < beams; ++i)
                scan.setScanRange(i, 1000 * scan.getScanRange(i));
        });
    EXPECT_THAT(troubles(report_), testing::HasSubstr("FAIL ranges.reach"));
}
}  // namespace
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#include <check_drive.h>
#include <gmock/gmock.h>
#include <rtob/check/stamp_check.h>

#include <limits>

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

CheckReport check_stamps(const std::vector<double>& stamps_s)
{
    StampCheck check;
    for (const double stamp_s : stamps_s) check.add(stamp_s);
    CheckReport report;
    check.report(report);
    return report;
}

/// Ten a second, from 100 s on.
std::vector<double> even_stamps(int count)
{
    std::vector<double> stamps_s;
    for (int k = 0; k < count; ++k) stamps_s.push_back(100 + 0.1 * k);
    return stamps_s;
}

TEST(StampCheck, EvenStampsAreFine)
{
    const auto report = check_stamps(even_stamps(100));
    EXPECT_EQ(troubles(report), "");
    EXPECT_NEAR(figure(report, "stamps.rate", "rate_hz"), 10, 1e-6);
    EXPECT_NEAR(figure(report, "stamps.rate", "jitter"), 0, 0.01);  // a bin is 1 % wide
}

TEST(StampCheck, NoScanAndOneScanSayNothing)
{
    EXPECT_TRUE(check_stamps({}).findings.empty());
    EXPECT_EQ(troubles(check_stamps({100})), "");
}

TEST(StampCheck, StepsBackRepeatsAndMissingStampsAreCounted)
{
    auto stamps_s = even_stamps(100);
    stamps_s[20] = stamps_s[19] - 0.7;
    stamps_s[40] = stamps_s[39];
    stamps_s[60] = std::numeric_limits<double>::quiet_NaN();
    const auto report = check_stamps(stamps_s);
    EXPECT_EQ(
        troubles(report), "WARN stamps.order, WARN stamps.gaps");  // 0.9 s after the step back
    EXPECT_EQ(figure(report, "stamps.order", "steps_back"), 1);
    EXPECT_NEAR(figure(report, "stamps.order", "worst_back_s"), 0.7, 1e-9);
    EXPECT_EQ(figure(report, "stamps.order", "repeats"), 1);
    EXPECT_EQ(figure(report, "stamps.order", "invalid"), 1);
}

TEST(StampCheck, AJumpIsNoGapAndDoesNotSpoilTheRate)
{
    auto stamps_s = even_stamps(100);
    for (std::size_t k = 50; k < 100; ++k) stamps_s[k] += 86400;
    const auto report = check_stamps(stamps_s);
    EXPECT_EQ(troubles(report), "WARN stamps.order");
    EXPECT_EQ(figure(report, "stamps.order", "jumps"), 1);
    EXPECT_NEAR(figure(report, "stamps.order", "largest_jump_s"), 86400.1, 1e-6);
    EXPECT_NEAR(figure(report, "stamps.rate", "rate_hz"), 10, 1e-6);
}

TEST(StampCheck, AGapIsNamedWithItsPlace)
{
    auto stamps_s = even_stamps(100);
    for (std::size_t k = 50; k < 100; ++k) stamps_s[k] += 3;
    const auto report = check_stamps(stamps_s);
    EXPECT_EQ(troubles(report), "WARN stamps.gaps");
    EXPECT_EQ(figure(report, "stamps.gaps", "gaps"), 1);
    EXPECT_NEAR(figure(report, "stamps.gaps", "largest_s"), 3.1, 1e-9);
    EXPECT_NEAR(figure(report, "stamps.gaps", "largest_at_s"), 104.9, 1e-9);
}

TEST(StampCheck, OneStampForAllFails)
{
    const auto report = check_stamps(std::vector<double>(50, 100.0));
    EXPECT_EQ(troubles(report), "FAIL stamps.order");
    EXPECT_THAT(report.findings[0].fix, HasSubstr("carmen2rawlog"));
}

TEST(StampCheck, NoStampAtAllFails)
{
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(troubles(check_stamps(std::vector<double>(50, none))), "FAIL stamps.order");
}

TEST(StampCheck, JitterAndSlownessAreNamed)
{
    std::vector<double> uneven_s, slow_s;
    for (int k = 0; k < 100; ++k)
    {
        uneven_s.push_back(100 + 0.1 * k + (k % 2 == 0 ? 0.03 : 0));
        slow_s.push_back(100 + 4.0 * k);
    }
    EXPECT_EQ(troubles(check_stamps(uneven_s)), "WARN stamps.rate");
    const auto slow = check_stamps(slow_s);
    EXPECT_EQ(troubles(slow), "WARN stamps.rate");
    EXPECT_NEAR(figure(slow, "stamps.rate", "rate_hz"), 0.25, 1e-9);
}
}  // namespace
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#include <check_drive.h>
#include <gmock/gmock.h>
#include <rtob/check/stamp_grid.h>

#include <cmath>
#include <limits>

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

/// @param shift_s of stamp k
template <class Shift>
CheckReport check_grid(int count, double interval_s, Shift&& shift_s)
{
    StampGrid check;
    // Six decimals, as logs hold them; a whole second is a whole number of microseconds.
    for (int k = 0; k < count; ++k)
        check.add(1e9 + std::round(1e6 * (interval_s * k + shift_s(k))) / 1e6);
    CheckReport report;
    check.report(report);
    return report;
}

double unshifted(int)
{
    return 0;
}

TEST(StampGrid, StampsComputedFromARateAreFound)
{
    const auto report = check_grid(500, 0.439192, unshifted);
    ASSERT_EQ(troubles(report), "WARN stamps.origin");
    EXPECT_NEAR(figure(report, "stamps.origin", "commonest_interval_s"), 0.439192, 1e-6);
    EXPECT_EQ(figure(report, "stamps.origin", "share"), 1);
    EXPECT_THAT(report.find("stamps.origin")->text, HasSubstr("0.439192 s"));
}

TEST(StampGrid, AlsoWhereAThirdOfThemWasMeasured)
{
    // Stamps 3, 6, 9 ... are off, each by another amount: of three intervals one is the grid's.
    const auto third = [](int k) { return k % 3 == 0 ? 1e-5 * (k % 100) : 0; };
    EXPECT_EQ(troubles(check_grid(500, 0.439192, third)), "");
    // Of five, three.
    const auto fifth = [](int k) { return k % 5 == 0 ? 1e-5 * (k % 100 + 1) : 0; };
    const auto report = check_grid(500, 0.439192, fifth);
    EXPECT_EQ(troubles(report), "WARN stamps.origin");
    EXPECT_NEAR(figure(report, "stamps.origin", "share"), 0.6, 0.01);
}

TEST(StampGrid, MeasuredStampsPass)
{
    // A regular laser, stamped within 0.5 ms by a quick computer.
    const auto jitter = [](int k) { return 5e-4 * std::sin(12.9898 * k); };
    EXPECT_EQ(troubles(check_grid(500, 0.0997, jitter)), "");
}

TEST(StampGrid, WholeMillisecondsPass)
{
    EXPECT_EQ(troubles(check_grid(500, 0.025, unshifted)), "");
}

TEST(StampGrid, FewOrMissingStampsSayNothing)
{
    EXPECT_TRUE(check_grid(100, 0.439192, unshifted).findings.empty());  // 99 intervals
    StampGrid check;
    for (int k = 0; k < 200; ++k) check.add(std::numeric_limits<double>::quiet_NaN());
    CheckReport report;
    check.report(report);
    EXPECT_TRUE(report.findings.empty());
}
}  // namespace
}  // namespace rtob::test

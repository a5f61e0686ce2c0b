// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/gaussian_sum.h>
#include <rtob/core/random.h>

#include <cmath>

using rtob::Box;
using rtob::ScanTable;

namespace
{
constexpr double kRelativeError = 1e-4;  // as the header promises
const Box kEverywhere{-1e9, -1e9, 1e9, 1e9};

/// Sec. 2.3.3 as written, without its constant factor.
double exact_sum(
    const ScanTable& table, const rtob::ScanRange& range, double time_s, double sigma_s,
    const Box& near)
{
    double sum = 0;
    for (std::size_t i = range.first; i < range.end; ++i)
    {
        if (!near.contains(table.x(i), table.y(i))) continue;
        const double z = (table.time(i) - time_s) / (std::sqrt(2.0) * sigma_s);
        sum += std::exp(-z * z);
    }
    return sum;
}
}  // namespace

TEST(GaussianSum, OfOneScanIsTheGaussianOverItsWholeReach)
{
    for (int i = -400; i <= 400; ++i)
    {
        ScanTable table;
        table.append(1000 + 0.01 * i * 2.5, {}, 1);  // sigma = 2.5 s, up to 4 sigma away
        const double exact = exact_sum(table, {0, 1}, 1000, 2.5, kEverywhere);
        ASSERT_NEAR(
            rtob::gaussian_sum(table, {0, 1}, 1000, 2.5, kEverywhere), exact,
            kRelativeError * exact);
    }
}

TEST(GaussianSum, EqualsTheExactSumForAnyLengthAndStart)
{
    rtob::Random random(1);
    ScanTable table;
    double time_s = 1e6;  // two weeks into the map
    for (int i = 0; i < 400; ++i)
    {
        table.append(time_s, {4 * random.uniform() - 2, 4 * random.uniform() - 2, 0}, 1);
        time_s += 0.2 * random.uniform();
    }
    const Box near = Box::around(0.25, -0.25, 1);
    for (int i = 0; i < 2000; ++i)
    {
        const std::size_t centre = random.below(400);
        const std::size_t first = table.backTo(table.time(centre) - 4, centre);
        const std::size_t end =
            first + random.below(table.forwardTo(table.time(centre) + 4, centre) - first + 1);
        const double exact = exact_sum(table, {first, end}, table.time(centre), 1, near);
        ASSERT_NEAR(
            rtob::gaussian_sum(table, {first, end}, table.time(centre), 1, near), exact,
            kRelativeError * exact)
            << "[" << first << ", " << end << ")";
    }
}

TEST(GaussianSum, CountsOnlyScansInsideBordersIncluded)
{
    ScanTable table;
    for (int i = 0; i < 20; ++i) table.append(5, {double(i), 0, 0}, 1);
    EXPECT_EQ(rtob::gaussian_sum(table, {0, 20}, 5, 1, Box{3, 0, 12, 0}), 10);
    EXPECT_EQ(rtob::gaussian_sum(table, {0, 20}, 5, 1, Box{20, 0, 30, 0}), 0);
    EXPECT_EQ(rtob::gaussian_sum(table, {4, 4}, 5, 1, kEverywhere), 0);
}

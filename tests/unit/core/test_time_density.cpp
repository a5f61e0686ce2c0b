// SPDX-License-Identifier: BSD-3-Clause
#include <density_formula.h>
#include <gtest/gtest.h>
#include <rtob/core/enum_names.h>
#include <test_map.h>

#include <cmath>
#include <vector>

using namespace rtob;
using rtob::test::TestMap;

namespace
{
DensityOptions options_of(Density density, double forgetting_s = 0)
{
    DensityOptions options;
    options.density = density;
    options.forgetting_s = forgetting_s;
    return options;
}

Support support_of(const TestMap& map, const DensityOptions& options, const Moment& now)
{
    Support support;
    TimeDensity(options).findSupport(map.scans, map.visits, now, support);
    return support;
}

/// One scan a second at x = 0, 1, 2 ... m.
TestMap straight_map(int scans)
{
    TestMap map;
    for (int k = 0; k < scans; ++k) map.add(k, {double(k), 0, 0}, 1);
    return map;
}

void expect_one_stretch(const Support& support, std::size_t first, std::size_t end)
{
    ASSERT_EQ(support.stretches.size(), 1u);
    EXPECT_EQ(support.stretches[0].scans.first, first);
    EXPECT_EQ(support.stretches[0].scans.end, end);
}
}  // namespace

TEST(TimeDensity, SupportsHoldTheirBorders)
{
    const TestMap map = straight_map(101);
    const Moment now{100, 50, 0};
    expect_one_stretch(support_of(map, options_of(Density::Uniform), now), 0, 101);
    expect_one_stretch(support_of(map, options_of(Density::Window), now), 70, 101);
    auto interval = options_of(Density::Interval);
    interval.interval_begin_s = 20;
    interval.interval_end_s = 40;
    expect_one_stretch(support_of(map, interval, now), 20, 41);
    // Within 2 m of x = 50: scans 48 to 52, and 4 sigma of 1 s on both sides.
    auto revisit = options_of(Density::Revisit);
    revisit.vicinity_m = 2;
    expect_one_stretch(support_of(map, revisit, now), 44, 57);
}

TEST(TimeDensity, VisitsCloserThanTheirGaussiansReachMakeOneStretch)
{
    TestMap map;
    for (int k = 0; k < 60; ++k)  // near at 0, 8, 17, 40 s
        map.add(k, {k == 0 || k == 8 || k == 17 || k == 40 ? 0.0 : 50.0, 0, 0}, 1);
    const auto support = support_of(map, options_of(Density::Revisit), {60, 0, 0});
    ASSERT_EQ(support.stretches.size(), 2u);  // 4..12 and 13..21 touch
    EXPECT_EQ(support.stretches[0].scans.first, 0u);
    EXPECT_EQ(support.stretches[0].scans.end, 22u);
    EXPECT_EQ(support.stretches[1].scans.first, 36u);
    EXPECT_EQ(support.stretches[1].scans.end, 45u);
}

TEST(TimeDensity, TheVicinityIsTheRangeOverRootTwo)
{
    auto options = options_of(Density::Revisit);
    options.laser_range_m = 6;
    EXPECT_DOUBLE_EQ(TimeDensity(options).vicinity(), 6 / std::sqrt(2.0));
    options.vicinity_m = 1.5;
    EXPECT_EQ(TimeDensity(options).vicinity(), 1.5);
}

TEST(TimeDensity, WeightsFollowTheFormulaAndStayBelowTheirBounds)
{
    Random random(4);
    TestMap map;
    double time_s = 0;
    for (int k = 0; k < 2000; ++k)
    {
        map.add(time_s, {10 * std::sin(0.01 * k), 3 * random.uniform(), 0}, 1);
        if (random.below(5) != 0) time_s += 0.3 * random.uniform();
    }
    const Moment now{time_s + 1, 2, 1};
    for (const double sigma_s : {0.2, 1.0, 2.5})
        for (const double forgetting_s : {0.0, 20.0})
        {
            auto options = options_of(Density::Revisit, forgetting_s);
            options.sigma_s = sigma_s;
            options.vicinity_m = 2;
            const TimeDensity density(options);
            Support support;
            density.findSupport(map.scans, map.visits, now, support);
            const double factor =  // forgetting counts from the newest of the support
                forgetting_s > 0 ? std::exp((now.time_s - support.newest_s) / forgetting_s) : 1;
            for (const Stretch& stretch : support.stretches)
                for (std::size_t k = stretch.scans.first; k < stretch.scans.end; ++k)
                {
                    const double weight = density.weight(map.scans, now, support, k);
                    const double exact =
                        factor * test::density_formula(options, map.scans, now, map.scans.time(k));
                    // 1e-4 of the sum, and what lies beyond 4 sigma.
                    ASSERT_NEAR(weight, exact, 1e-4 * exact + 0.01) << "scan " << k;
                    ASSERT_LE(weight, stretch.bound) << "scan " << k;
                }
        }
}

TEST(TimeDensity, OnlyNegligibleWeightIsOutsideTheSupport)
{
    const TestMap map = straight_map(2000);
    const Moment now{1999, 1000, 0};
    for (const auto& options :
         {options_of(Density::Forgetting, 50), options_of(Density::Revisit, 50)})
    {
        double all = 0, inside = 0;
        for (std::size_t k = 0; k < map.scans.size(); ++k)
            all += test::density_formula(options, map.scans, now, map.scans.time(k));
        for (const Stretch& stretch : support_of(map, options, now).stretches)
            for (std::size_t k = stretch.scans.first; k < stretch.scans.end; ++k)
                inside += test::density_formula(options, map.scans, now, map.scans.time(k));
        EXPECT_GT(inside / all, 0.999) << name_of(options.density);
    }
}

TEST(TimeDensity, TheSupportOfManyVisitsIsBoundedAndHoldsThemAll)
{
    TestMap map;  // 3000 visits, 20 s apart: more than kMaxVisits
    for (int k = 0; k < 60000; ++k) map.add(k, {k % 20 == 0 ? 0.0 : 50.0, 0, 0}, 1);
    for (const double forgetting_s : {0.0, 5000.0})
    {
        const auto support =
            support_of(map, options_of(Density::Revisit, forgetting_s), {60000, 0, 0});
        // Forgetting cuts what there is at 56 ages.
        EXPECT_LE(support.stretches.size(), TimeDensity::kMaxVisits + 56);
        std::vector<bool> in(60000);
        for (const Stretch& stretch : support.stretches)
            for (auto k = stretch.scans.first; k < stretch.scans.end; ++k) in[k] = true;
        for (std::size_t k = 0; k < 60000; k += 20) ASSERT_TRUE(in[k]) << "visit at " << k;
    }
}

TEST(TimeDensity, IsFlatWhereNothingVaries)
{
    EXPECT_TRUE(TimeDensity(options_of(Density::Uniform)).isFlat());
    EXPECT_TRUE(TimeDensity(options_of(Density::Window)).isFlat());
    EXPECT_FALSE(TimeDensity(options_of(Density::Window, 10)).isFlat());
    EXPECT_FALSE(TimeDensity(options_of(Density::Revisit)).isFlat());
}

TEST(DensityOptions, RefusesWhatIsOutOfRange)
{
    const auto refused = [](const auto& change)
    {
        DensityOptions options;
        change(options);
        EXPECT_THROW(TimeDensity{options}, std::invalid_argument);
    };
    refused([](auto& o) { o.interval_begin_s = -1; });
    refused([](auto& o) { o.interval_begin_s = o.interval_end_s; });
    refused([](auto& o) { o.window_s = 0; });
    refused([](auto& o) { o.forgetting_s = -1; });
    refused([](auto& o) { o.density = Density::Forgetting; });  // without forgetting_s
    refused([](auto& o) { o.sigma_s = 0; });
    refused([](auto& o) { o.laser_range_m = 0; });
    refused([](auto& o) { o.vicinity_m = -1; });
    refused([](auto& o) { o.gate_m = -1; });
    refused([](auto& o) { o.sigma_s = std::nan(""); });
}

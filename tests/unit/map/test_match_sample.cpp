// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/random.h>
#include <rtob/map/match_sample.h>

#include <cmath>
#include <limits>

using rtob::MatchSample;
using rtob::Points;
using rtob::Random;
using rtob::Reference;
using rtob::scan_hash;

namespace
{
double uniform(Random& random, double low, double high)
{
    return low + (high - low) * random.uniform();
}

/// 500 points within 5 m of (100, -50).
void fill(Reference& reference, Random& random)
{
    reference.points.clear();
    reference.origin_x = 100;
    reference.origin_y = -50;
    for (int i = 0; i < 500; ++i)
        reference.points.add(
            static_cast<float>(uniform(random, -5, 5)), static_cast<float>(uniform(random, -5, 5)));
}

double squared_distance_by_brute_force(const Reference& reference, double x_map, double y_map)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < reference.points.size(); ++i)
        least = std::min(
            least, std::pow(reference.points.x[i] + reference.origin_x - x_map, 2) +
                       std::pow(reference.points.y[i] + reference.origin_y - y_map, 2));
    return least;
}
}  // namespace

TEST(MatchSample, FindsWhatBruteForceFinds)
{
    Random random(7);
    MatchSample sample;
    fill(sample.renew(1), random);
    const Reference& reference = sample.reference();
    int found = 0;
    for (int query = 0; query < 20000; ++query)
    {
        const double usual_m = query < 10000 ? 0.2 : 0.05;  // a matcher shrinks its radius
        sample.prepare(usual_m, 1.0);
        const double radius_m = query % 2 ? usual_m : uniform(random, usual_m, 1.0);
        const double x = uniform(random, 93, 107), y = uniform(random, -57, -43);
        const double truth = squared_distance_by_brute_force(reference, x, y);
        const auto near = sample.nearest(x, y, radius_m);
        if (std::abs(std::sqrt(truth) - radius_m) < 1e-5) continue;  // floats may see either
        ASSERT_EQ(near.has_value(), truth < radius_m * radius_m) << x << " " << y;
        ASSERT_NEAR(sample.squaredDistance(x, y), truth, 1e-4);
        if (!near) continue;
        ++found;
        ASSERT_NEAR(near->squared_distance, truth, 1e-5);
        // The index counts points as drawn, not as the grid sorts them.
        ASSERT_NEAR(
            std::hypot(
                reference.points.x[near->drawn] + 100 - x,
                reference.points.y[near->drawn] - 50 - y),
            std::sqrt(truth), 1e-5);
    }
    EXPECT_GT(found, 1000);
}

TEST(MatchSample, OfNothingFindsNothing)
{
    MatchSample sample;
    EXPECT_TRUE(sample.empty());
    sample.renew(1).points.clear();
    sample.prepare(0.3, 2.0);
    EXPECT_FALSE(sample.empty());
    EXPECT_FALSE(sample.nearest(0, 0, 2.0));
    EXPECT_TRUE(std::isinf(sample.squaredDistance(0, 0)));
}

TEST(MatchSample, BelongsToOneScanAtOnePlace)
{
    MatchSample sample;
    EXPECT_FALSE(sample.isFor(1, {}, 1.0));
    sample.renew(1).origin_x = 5;
    EXPECT_TRUE(sample.isFor(1, {5, 0.9, 2}, 1.0));
    EXPECT_FALSE(sample.isFor(2, {5, 0, 0}, 1.0));
    EXPECT_FALSE(sample.isFor(1, {5, 1.1, 0}, 1.0));
    sample.reset();
    EXPECT_FALSE(sample.isFor(1, {5, 0, 0}, 1.0));
}

TEST(ScanHash, TellsScansApart)
{
    Points a, b, swapped;
    a.add(1, 2);
    b.add(1, std::nextafter(2.0f, 3.0f));
    swapped.add(2, 1);
    EXPECT_EQ(scan_hash(a.view()), scan_hash(Points(a).view()));
    EXPECT_NE(scan_hash(a.view()), scan_hash(b.view()));
    EXPECT_NE(scan_hash(a.view()), scan_hash(swapped.view()));
    EXPECT_NE(scan_hash(a.view()), scan_hash({}));
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/correspondences.h>
#include <rtob/core/random.h>

#include <cmath>
#include <cstddef>

using namespace rtob;

namespace
{
Points cloud(std::size_t points, double half_width_m, Random& random)
{
    Points cloud;
    for (std::size_t i = 0; i < points; ++i)
        cloud.add(
            static_cast<float>(half_width_m * (2 * random.uniform() - 1)),
            static_cast<float>(half_width_m * (2 * random.uniform() - 1)));
    return cloud;
}

/// Squared distance to the nearest point, or -1 beyond the radius.
float brute_force(const PointsView& points, float x, float y, double radius_m)
{
    const auto limit_m = static_cast<float>(radius_m);
    float best = -1;
    for (std::size_t i = 0; i < points.size; ++i)
    {
        const float dx = points.x[i] - x, dy = points.y[i] - y;
        const float d2 = dx * dx + dy * dy;
        if (d2 <= limit_m * limit_m && (best < 0 || d2 < best)) best = d2;
    }
    return best;
}

/// A scan that takes steps of the given size, as an alignment does, and what is paired after each.
void expect_brute_force(double step_m, double step_rad, double first_m, double last_m)
{
    Random random(5);
    for (int world = 0; world < 20; ++world)
    {
        const Points reference_points = cloud(400, 2, random), scan = cloud(60, 2.3, random);
        IcpReference reference;
        reference.build(reference_points.view(), first_m, 0, first_m);
        PairTable table;
        Correspondences correspondences;
        table.reset(scan.size());
        correspondences.reset(scan.size());
        Pose2 pose{0.2, -0.1, 0.05};
        for (int step = 0; step < 30; ++step)
        {
            const double radius_m = step < 10 ? first_m : last_m;
            pose.x += step_m * (random.uniform() - 0.5);
            pose.y += step_m * (random.uniform() - 0.5);
            pose.yaw += step_rad * (random.uniform() - 0.5);
            table.move(scan.view(), pose);
            correspondences.find(reference, radius_m, false, table);
            std::size_t pairs = 0;
            for (std::size_t i = 0; i < scan.size(); ++i)
            {
                const float expected = brute_force(
                    reference_points.view(), table.points().x[i], table.points().y[i], radius_m);
                pairs += expected >= 0 ? 1 : 0;
                ASSERT_EQ(table.isPaired(i), expected >= 0) << "step " << step;
                ASSERT_TRUE(expected < 0 || table.squaredDistance(i) == expected);
            }
            ASSERT_EQ(table.pairs(), pairs);
        }
    }
}
}  // namespace

TEST(Correspondences, EqualBruteForceInSmallStepsInWhichNeighboursStay)
{
    expect_brute_force(0.002, 0.0005, 0.3, 0.3);
}

TEST(Correspondences, EqualBruteForceInLargeSteps)
{
    expect_brute_force(0.2, 0.1, 0.6, 0.6);
}

TEST(Correspondences, EqualBruteForceWhileTheDistanceShrinks)
{
    expect_brute_force(0.02, 0.005, 0.6, 0.1);
}

TEST(Correspondences, ForgetTheScanBefore)
{
    Points reference_points, scan;
    reference_points.add(0, 0);
    reference_points.add(1, 0);
    scan.add(0.1f, 0);
    IcpReference reference;
    reference.build(reference_points.view(), 0.3, 0, 0.3);
    PairTable table;
    Correspondences correspondences;
    for (const float x : {0.1f, 0.9f})
    {
        scan.x[0] = x;
        table.reset(1);
        correspondences.reset(1);
        table.move(scan.view(), {});
        correspondences.find(reference, 0.3, false, table);
        ASSERT_TRUE(table.isPaired(0));
        EXPECT_NEAR(table.squaredDistance(0), 0.01f, 1e-6f);
    }
}

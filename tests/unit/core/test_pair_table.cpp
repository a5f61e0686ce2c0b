// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/enum_names.h>
#include <rtob/core/pair_table.h>
#include <rtob/core/random.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

namespace
{
using rtob::PairTable;
using rtob::RobustKernel;

constexpr double kScale_m = 0.2;

struct Pair
{
    float x, y, neighbour_x, neighbour_y, normal_x = 0, normal_y = 0;
};

/// Pairs up to 0.4 m apart; every third is on no line. Their number fills no whole block.
std::vector<Pair> some_pairs(std::size_t count)
{
    rtob::Random random(7);
    const auto between = [&](double low, double high)
    { return static_cast<float>(low + (high - low) * random.uniform()); };
    std::vector<Pair> pairs;
    for (std::uint32_t i = 0; i < count; ++i)
    {
        Pair pair{between(-9, 9), between(-6, 6), 0, 0};
        pair.neighbour_x = pair.x + between(-0.28, 0.28);
        pair.neighbour_y = pair.y + between(-0.28, 0.28);
        const float angle = between(-3, 3);
        if (i % 3 != 0) pair.normal_x = std::cos(angle), pair.normal_y = std::sin(angle);
        pairs.push_back(pair);
    }
    return pairs;
}

PairTable table_of(const std::vector<Pair>& pairs, double max_distance_m = 1)
{
    PairTable table;
    table.reset(pairs.size());
    rtob::Points scan;
    for (const auto& pair : pairs) scan.add(pair.x, pair.y);
    table.move(scan.view(), {});
    for (std::size_t i = 0; i < pairs.size(); ++i)
        table.pair(
            i, {pairs[i].neighbour_x, pairs[i].neighbour_y, pairs[i].normal_x, pairs[i].normal_y});
    table.measure(max_distance_m);
    return table;
}

/// The kernels as their definitions have them.
double weight_of(RobustKernel kernel, double residual)
{
    const double e = std::abs(residual) / kScale_m;
    switch (kernel)
    {
        case RobustKernel::None:
            return 1;
        case RobustKernel::Huber:
            return e <= 1 ? 1 : 1 / e;
        case RobustKernel::Cauchy:
            return 1 / (1 + e * e);
        case RobustKernel::Tukey:
            return e <= 1 ? std::pow(1 - e * e, 2) : 0;
    }
    return 0;
}

double residual_of(const Pair& pair, bool to_line)
{
    if (!to_line || (pair.normal_x == 0 && pair.normal_y == 0))
        return std::hypot(pair.x - pair.neighbour_x, pair.y - pair.neighbour_y);
    return pair.normal_x * (pair.x - pair.neighbour_x) +
           pair.normal_y * (pair.y - pair.neighbour_y);
}

class PairTableKernels : public testing::TestWithParam<RobustKernel>
{
};

INSTANTIATE_TEST_SUITE_P(
    All, PairTableKernels,
    testing::Values(
        RobustKernel::None, RobustKernel::Huber, RobustKernel::Cauchy, RobustKernel::Tukey),
    [](const auto& kernel) { return std::string(rtob::name_of(kernel.param)); });
}  // namespace

TEST_P(PairTableKernels, NormalEquationsAreTheSumsOverThePairs)
{
    constexpr double along_line = 0.02, center_x = 0.3, center_y = -0.2;
    const auto pairs = some_pairs(101);
    Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
    Eigen::Vector3d g = Eigen::Vector3d::Zero();
    for (const auto& pair : pairs)
    {
        const Eigen::Vector2d normal(pair.normal_x, pair.normal_y), along(-normal.y(), normal.x());
        const Eigen::Vector2d error(pair.x - pair.neighbour_x, pair.y - pair.neighbour_y);
        Eigen::Matrix2d metric = Eigen::Matrix2d::Identity();
        if (!normal.isZero())
            metric = normal * normal.transpose() + along_line * along * along.transpose();
        Eigen::Matrix<double, 2, 3> jacobian;
        jacobian << 1, 0, center_y - pair.y, 0, 1, pair.x - center_x;
        const double w = weight_of(GetParam(), residual_of(pair, true));
        h += w * jacobian.transpose() * metric * jacobian;
        g += w * jacobian.transpose() * metric * error;
    }
    PairTable table = table_of(pairs);
    table.weigh(GetParam(), kScale_m, true);
    const auto equations = table.normalEquations(center_x, center_y, along_line);
    EXPECT_LT((equations.h - h).norm(), 1e-5 * h.norm());
    EXPECT_LT((equations.g - g).norm(), 1e-5 * h.norm());
}

TEST_P(PairTableKernels, TheRigidMotionIsTheWeightedUmeyama)
{
    const auto pairs = some_pairs(99);
    // Weighted Umeyama by its definition, in double.
    double sum = 0;
    Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
    for (const auto& pair : pairs)
    {
        const double w = weight_of(GetParam(), residual_of(pair, false));
        sum += w;
        from += w * Eigen::Vector2d(pair.x, pair.y);
        to += w * Eigen::Vector2d(pair.neighbour_x, pair.neighbour_y);
    }
    from /= sum;
    to /= sum;
    Eigen::Matrix2d cross = Eigen::Matrix2d::Zero();
    for (const auto& pair : pairs)
        cross += weight_of(GetParam(), residual_of(pair, false)) *
                 (Eigen::Vector2d(pair.x, pair.y) - from) *
                 (Eigen::Vector2d(pair.neighbour_x, pair.neighbour_y) - to).transpose();
    const double yaw = std::atan2(cross(0, 1) - cross(1, 0), cross(0, 0) + cross(1, 1));
    const Eigen::Vector2d shift = to - Eigen::Rotation2Dd(yaw) * from;

    PairTable table = table_of(pairs);
    table.weigh(GetParam(), kScale_m, false);
    const rtob::Pose2 motion = table.rigidMotion();
    EXPECT_NEAR(motion.yaw, yaw, 1e-6);
    EXPECT_NEAR(motion.x, shift.x(), 1e-5);
    EXPECT_NEAR(motion.y, shift.y(), 1e-5);
}

TEST(PairTable, MovesTheScanByThePose)
{
    PairTable table;
    table.reset(1);
    rtob::Points scan;
    scan.add(2, 1);
    table.move(scan.view(), {10, 20, 1.5707963267948966});
    EXPECT_NEAR(table.points().x[0], 9, 1e-6);
    EXPECT_NEAR(table.points().y[0], 22, 1e-6);
}

TEST(PairTable, OnlyPairsWithinTheDistanceCount)
{
    const auto pairs = some_pairs(40);
    std::size_t near = 0;
    for (const auto& pair : pairs) near += residual_of(pair, false) <= 0.2 ? 1 : 0;
    ASSERT_GT(near, 5u);
    ASSERT_LT(near, 35u);
    PairTable table = table_of(pairs, 0.2);
    EXPECT_EQ(table.scanPoints(), 40u);
    EXPECT_EQ(table.pairs(), near);
    table.weigh(RobustKernel::None, kScale_m, false);
    EXPECT_NEAR(table.normalEquations(0, 0, 1).h(0, 0), static_cast<double>(near), 1e-4);
}

TEST(PairTable, PointsThatAreAloneDoNotCount)
{
    const auto pairs = some_pairs(40);
    PairTable table = table_of(pairs);
    for (std::size_t i = 1; i < pairs.size(); ++i) table.leaveAlone(i);
    table.measure(1);
    EXPECT_EQ(table.pairs(), 1u);
    EXPECT_TRUE(table.isPaired(0));
    EXPECT_FALSE(table.isPaired(1));
    for (const bool to_line : {false, true})
    {
        table.weigh(RobustKernel::None, kScale_m, to_line);
        EXPECT_NEAR(table.normalEquations(0, 0, 0).h(0, 0), 1, 1e-6);
        EXPECT_TRUE(std::isfinite(table.rigidMotion().x));
    }
}

TEST(PairTable, NoPairsMoveNothing)
{
    PairTable table;
    table.weigh(RobustKernel::Tukey, kScale_m, true);
    EXPECT_EQ(table.rigidMotion().x, 0);
    EXPECT_TRUE(table.normalEquations(0, 0, 0.02).h.isZero());
}

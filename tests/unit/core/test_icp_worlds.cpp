// SPDX-License-Identifier: BSD-3-Clause
// Noise-free worlds whose points are all in the reference are matched exactly.
#include <gtest/gtest.h>
#include <near_pose.h>
#include <rtob/core/icp.h>
#include <worlds.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

using namespace rtob;
using rtob::test::IsNearPose;
using rtob::test::World;

namespace
{
constexpr double kDegree = 3.14159265358979323846 / 180;

struct Setting
{
    std::string name;
    IcpOptions options;
    double largest_offset_m = 0.3;
};

IcpOptions icp_options(IcpMetric metric, RobustKernel kernel, bool coarse_to_fine)
{
    IcpOptions options = test::paper_icp_options();
    options.metric = metric;
    options.kernel = kernel;
    if (coarse_to_fine)
    {
        options.max_pair_distance_m = 0.6;
        options.final_pair_distance_m = 0.1;
        options.kernel_scale_m = 0.05;
    }
    else
        options.kernel_scale_m = 0.3;  // a smaller one holds the scan where it is
    return options;
}

std::vector<Setting> settings()
{
    constexpr auto kPoint = IcpMetric::PointToPoint, kLine = IcpMetric::PointToLine;
    return {
        {"paper", test::paper_icp_options()},
        {"line", icp_options(kLine, RobustKernel::None, false)},
        {"huber", icp_options(kPoint, RobustKernel::Huber, false)},
        {"cauchy", icp_options(kPoint, RobustKernel::Cauchy, false)},
        // Tukey's weight of the farthest points is 0, and from 0.3 m they decide now and then.
        {"tukey", icp_options(kPoint, RobustKernel::Tukey, false), 0.2},
        {"coarse_to_fine", icp_options(kPoint, RobustKernel::None, true)},
        {"line_coarse_to_fine", icp_options(kLine, RobustKernel::None, true)},
        {"line_cauchy_coarse_to_fine", icp_options(kLine, RobustKernel::Cauchy, true)}};
}

class IcpWorlds : public testing::TestWithParam<std::tuple<World, Setting>>
{
};

/// 8 directions x 3 distances x 3 turns around the true pose.
std::vector<Pose2> guesses(const Pose2& truth, double largest_offset_m)
{
    std::vector<Pose2> all{truth};
    for (const double distance_m : {0.1, 0.2, 0.3})
        for (int direction = 0; direction < 8; ++direction)
            for (const double turn_deg : {-5.0, 0.0, 5.0})
                if (distance_m <= largest_offset_m)
                {
                    const double angle = direction * 45 * kDegree;
                    all.push_back(
                        {truth.x + distance_m * std::cos(angle),
                         truth.y + distance_m * std::sin(angle), truth.yaw + turn_deg * kDegree});
                }
    return all;
}

std::string case_name(const testing::TestParamInfo<std::tuple<World, Setting>>& info)
{
    return std::get<0>(info.param).name + "_" + std::get<1>(info.param).name;
}
}  // namespace

TEST_P(IcpWorlds, AreMatchedToAMillimetre)
{
    const auto& [world, setting] = GetParam();
    Icp icp(setting.options);
    for (const Pose2& guess : guesses(world.pose_map_vehicle, setting.largest_offset_m))
    {
        const auto m = test::matching(world, guess);
        const auto result = icp.align(m.scan.view(), m.reference.view());
        EXPECT_THAT(result.correction, IsNearPose(m.truth, 1e-3, 0.05 * kDegree));
        EXPECT_THAT(
            apply_correction(guess, result.correction),
            IsNearPose(world.pose_map_vehicle, 1e-3, 0.05 * kDegree));
        EXPECT_EQ(result.paired_share, 1);
        EXPECT_LT(result.mean_squared_error, 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, IcpWorlds,
    testing::Combine(testing::ValuesIn(test::worlds()), testing::ValuesIn(settings())), case_name);

TEST(IcpWorlds, PointsOfOtherScansDoNotPullTheScanAway)
{
    for (const World& world : test::worlds())
    {
        Pose2 guess = world.pose_map_vehicle;
        guess.x += 0.1;
        guess.y -= 0.1;
        guess.yaw += 2 * kDegree;
        auto m = test::matching(world, guess);
        for (int i = 0; i < 9; ++i)  // 3600 points in all, as the paper draws
        {
            const Pose2 other{
                world.pose_map_vehicle.x + 0.1 * std::cos(0.7 * i),
                world.pose_map_vehicle.y + 0.1 * std::sin(0.7 * i), 0.3 * i};
            const Points points = test::moved(
                world.room.scan_vehicle(other), {other.x - guess.x, other.y - guess.y, other.yaw});
            for (std::size_t k = 0; k < points.size(); ++k)
                m.reference.add(points.x[k], points.y[k]);
        }
        const auto result = Icp(test::paper_icp_options()).align(m.scan.view(), m.reference.view());
        EXPECT_THAT(result.correction, IsNearPose(m.truth, 5e-3, 0.2 * kDegree)) << world.name;
    }
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/map/rtob_map.h>
#include <rtob/slam/map_belief.h>

namespace rtob
{
namespace
{
/// Scans a metre apart along x; the k-th is off by k^2 cm^2 along it, and turned with it.
class MapBeliefTest : public testing::Test
{
 protected:
    void write(int scans)
    {
        Points points;
        points.add(1, 0);
        for (int k = 0; k < scans; ++k)
        {
            map_.insertScan(map_.tick(k), {static_cast<double>(k), 0, 0}, points.view());
            belief_.inserted(covarianceOf(k));
        }
    }
    static Eigen::Matrix3d covarianceOf(int k)
    {
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        covariance(0, 0) = 1e-4 * k * k;
        covariance(0, 2) = covariance(2, 0) = 1e-5 * k;
        covariance(2, 2) = 1e-6;
        return covariance;
    }
    RtobMap map_;
    MapBelief belief_;
};
}  // namespace

TEST_F(MapBeliefTest, IsTheMeanOfTheOldScansNearby)
{
    write(100);
    // 16.5 to 23.5 m, of the first 20 scans: 17, 18 and 19
    const Eigen::Matrix3d mean = (covarianceOf(17) + covarianceOf(18) + covarianceOf(19)) / 3;
    EXPECT_TRUE(belief_.near(map_.view(), {20.5, 0, 1}, 20).isApprox(mean, 1e-6));
}

TEST_F(MapBeliefTest, KnowsNothingWhereNoOldScanIsNear)
{
    write(30);
    EXPECT_TRUE(belief_.near(map_.view(), {20, 50, 0}, 30).isZero());
    EXPECT_TRUE(belief_.near(map_.view(), {20, 0, 0}, 10).isZero());
    EXPECT_TRUE(belief_.near(map_.view(), {20, 0, 0}, 0).isZero());
}

TEST_F(MapBeliefTest, LooksAtScansEvenlyWhereTheyAreMany)
{
    for (int i = 0; i < 100; ++i) write(5);
    const Eigen::Matrix3d mean =
        (covarianceOf(1) + covarianceOf(2) + covarianceOf(3) + covarianceOf(4)) / 5;
    EXPECT_TRUE(belief_.near(map_.view(), {2, 0, 0}, 500).isApprox(mean, 0.1));
}

TEST_F(MapBeliefTest, ForgetsWithTheMap)
{
    write(40);
    std::vector<char> keep(40, 0);
    keep[20] = keep[30] = 1;
    map_.keepOnly(keep);
    belief_.keepOnly(keep);
    EXPECT_TRUE(belief_.near(map_.view(), {20, 0, 0}, 2).isApprox(covarianceOf(20), 1e-6));
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <rtob/map/conversions.h>
#include <rtob/slam/slam_map_builder.h>

#include <stdexcept>

#include "drive_log.h"
#include "error_message.h"
#include "near_pose.h"
#include "temporary_folder.h"

using namespace rtob;
using test::IsNearPose;

namespace
{
constexpr int kScans = 40;

/// Odometry and scan in turn, to both of them.
void drive(SlamMapBuilder& builder, Slam& slam)
{
    for (int k = 0; k < kScans; ++k)
    {
        builder.processObservation(test::odometry_on_circle(k));
        builder.processObservation(test::scan_on_circle(k));
        slam.observe(*test::odometry_on_circle(k));
        slam.observe(*test::scan_on_circle(k));
    }
}

Pose2 pose_of(const SlamMapBuilder& builder)
{
    return to_pose2(mrpt::poses::CPose2D(builder.getCurrentPoseEstimation()->getMeanVal()));
}
}  // namespace

TEST(SlamMapBuilder, DoesWhatSlamDoes)
{
    SlamMapBuilder builder;
    Slam slam;
    drive(builder, slam);
    EXPECT_THAT(pose_of(builder), IsNearPose(slam.pose(), 0.0, 1e-15));
    EXPECT_THAT(pose_of(builder), IsNearPose(test::pose_on_circle_map(kScans - 1), 0.01, 0.01));

    const auto* maps = builder.getCurrentlyBuiltMetricMap();
    ASSERT_EQ(maps->maps.size(), 1U);
    const auto map = maps->mapByClass<RtobMap>();
    ASSERT_TRUE(map);
    EXPECT_EQ(map->getPointsBufferRef_x(), slam.map().getPointsBufferRef_x());
    EXPECT_EQ(map->getPointsBufferRef_y(), slam.map().getPointsBufferRef_y());
    EXPECT_EQ(map->scans().size(), slam.map().scans().size());
}

TEST(SlamMapBuilder, GivesTheUncertaintyOfThePose)
{
    SlamMapBuilder builder;
    Slam slam;
    drive(builder, slam);
    const auto* last = slam.observe(*test::scan_on_circle(kScans));
    ASSERT_NE(last, nullptr);
    builder.processObservation(test::scan_on_circle(kScans));
    const auto [covariance, mean] = builder.getCurrentPoseEstimation()->getCovarianceAndMean();
    EXPECT_GT(covariance(0, 0), 0);
    EXPECT_EQ(covariance(0, 0), last->covariance(0, 0));
    EXPECT_EQ(covariance(0, 1), last->covariance(0, 1));
    EXPECT_EQ(covariance(3, 3), last->covariance(2, 2)) << "MRPT's order is x y z yaw pitch roll";
    EXPECT_EQ(covariance(2, 2), 0) << "z is not estimated";
}

TEST(SlamMapBuilder, TakesActionsAndSensoryFrames)
{
    SlamMapBuilder builder;
    Slam slam;
    for (int k = 0; k < kScans; ++k)
    {
        const Pose2 step = between(test::pose_on_circle(k - 1), test::pose_on_circle(k));
        mrpt::obs::CActionRobotMovement2D motion;
        motion.computeFromOdometry(to_cpose2d(step), {});
        mrpt::obs::CActionCollection action;
        action.insert(motion);
        mrpt::obs::CSensoryFrame frame;
        frame.insert(test::scan_on_circle(k));
        builder.processActionObservation(action, frame);
        slam.observe(motion);
        slam.observe(*test::scan_on_circle(k));
    }
    EXPECT_TRUE(builder.slam().hasOdometry());
    EXPECT_THAT(pose_of(builder), IsNearPose(slam.pose(), 0.0, 1e-15));
}

TEST(SlamMapBuilder, KeepsTheScansThatWereWritten)
{
    SlamOptions options;
    options.insertion.angle_deg = 0;
    options.insertion.distance_m = 0.2;  // of the 5 cm a scan: not every one
    SlamMapBuilder builder(options);
    Slam slam(options);
    drive(builder, slam);
    mrpt::maps::CSimpleMap run;
    builder.getCurrentlyBuiltMap(run);
    ASSERT_EQ(run.size(), slam.map().scans().size());
    EXPECT_LT(run.size(), static_cast<std::size_t>(kScans));
    EXPECT_EQ(builder.getCurrentlyBuiltMapSize(), run.size());
    for (std::size_t k = 0; k < run.size(); ++k)
    {
        const auto& [pose, frame] = run.get(k);
        EXPECT_THAT(
            to_pose2(mrpt::poses::CPose2D(pose->getMeanVal())),
            IsNearPose(slam.map().scans().pose(k), 0.0, 1e-15));
        EXPECT_EQ(frame->size(), 1U);
    }
}

TEST(SlamMapBuilder, BeginsAnewWhenInitialized)
{
    SlamMapBuilder builder, fresh;
    Slam slam, again;
    drive(builder, slam);
    const mrpt::poses::CPosePDFGaussian x0(mrpt::poses::CPose2D(5, 6, 1));
    builder.initialize({}, &x0);
    EXPECT_EQ(builder.getCurrentlyBuiltMapSize(), 0U);
    EXPECT_TRUE(builder.getCurrentlyBuiltMetricMap()->mapByClass<RtobMap>()->empty());
    EXPECT_THAT(pose_of(builder), IsNearPose(Pose2{5, 6, 1}, 0.0, 0.0));
    builder.processObservation(test::scan_on_circle(0));
    EXPECT_THAT(pose_of(builder), IsNearPose(Pose2{5, 6, 1}, 1e-12, 1e-12));

    builder.clear();
    drive(builder, again);
    EXPECT_THAT(pose_of(builder), IsNearPose(again.pose(), 0.0, 1e-15)) << "as from the start";
}

TEST(SlamMapBuilder, RefusesWhatItCannotTake)
{
    SlamMapBuilder builder;
    EXPECT_THROW(builder.processObservation(nullptr), std::invalid_argument);
    mrpt::maps::CSimpleMap given;
    given.insert(mrpt::poses::CPose3DPDFGaussian::Create(), mrpt::obs::CSensoryFrame::Create());
    EXPECT_NE(
        test::error_message<std::invalid_argument>([&] { builder.initialize(given); })
            .find("1 frames"),
        std::string::npos);
}

TEST(SlamMapBuilder, DrawsPointsAndPath)
{
    SlamMapBuilder builder;
    Slam slam;
    drive(builder, slam);
    const test::TemporaryFolder folder;
    const std::string file = folder.file("map.png");
    builder.saveCurrentEstimationToImage(file);
    mrpt::img::CImage image;
    ASSERT_TRUE(image.loadFromFile(file));
    // The room's diagonal of 5 m, turned by 90 degrees, with a margin of 0.5 m: 3 x 4 m at 5 cm.
    EXPECT_NEAR(static_cast<double>(image.getWidth()), (3 + 1) / 0.05, 3);
    EXPECT_NEAR(static_cast<double>(image.getHeight()), (4 + 1) / 0.05, 3);
    int black = 0, red = 0;
    for (std::size_t y = 0; y < image.getHeight(); ++y)
        for (std::size_t x = 0; x < image.getWidth(); ++x)
        {
            const auto* bgr =
                image.ptr<std::uint8_t>(static_cast<unsigned>(x), static_cast<unsigned>(y));
            black += bgr[0] == 0 && bgr[1] == 0 && bgr[2] == 0;
            red += bgr[0] == 0 && bgr[1] == 0 && bgr[2] == 255;
        }
    EXPECT_GT(black, 200) << "14 m of wall are 280 pixels";
    EXPECT_GT(red, 20) << "2 m of path are 40 pixels";
}

TEST(SlamMapBuilder, SaysWhichPictureCannotBeWritten)
{
    SlamMapBuilder builder;
    const test::TemporaryFolder folder;
    for (const std::string& file : {folder.file("map.emf"), folder.file("none/map.png")})
        EXPECT_NE(
            test::error_message([&] { builder.saveCurrentEstimationToImage(file); }).find(file),
            std::string::npos)
            << file;
}

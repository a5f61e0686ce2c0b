// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <rtob/drivers/log_player.h>
#include <rtob/drivers/unix_time.h>
#include <rtob/io/capture_file.h>
#include <rtob/io/scan_timing.h>

#include <thread>

#include "temporary_folder.h"

namespace rtob
{
namespace
{
using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;

CObservation2DRangeScan::Ptr scan_at(double stamp_s)
{
    auto scan = CObservation2DRangeScan::Create();
    scan->timestamp = mrpt::Clock::fromDouble(stamp_s);
    scan->sensorLabel = "FRONT";
    scan->resizeScan(1);
    scan->setScanRange(0, static_cast<float>(stamp_s - 1000));
    return scan;
}

class LogPlayerTest : public testing::Test
{
 protected:
    void play(const std::string& keys = "")
    {
        const mrpt::config::CConfigFileMemory config(
            "[LOG]\ndriver = RtobLogPlayer\nprocess_rate = 100\nfile = " + log_ + "\n" + keys);
        player_.loadConfig(config, "LOG");
        player_.initialize();
    }
    /// What comes until there are so many.
    std::vector<CObservation::Ptr> observations(std::size_t count)
    {
        std::vector<CObservation::Ptr> all;
        for (const double end = unix_time_s() + 30; all.size() < count && unix_time_s() < end;)
        {
            player_.doProcess();
            for (const auto& [stamp, object] : player_.getObservations())
                all.push_back(std::dynamic_pointer_cast<CObservation>(object));
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return all;
    }
    static double stamp_of(const CObservation& observation)
    {
        return mrpt::Clock::toDouble(observation.timestamp);
    }

    test::TemporaryFolder folder_;
    std::string log_ = folder_.file("log.rawlog");
    RtobLogPlayer player_;
};

TEST_F(LogPlayerTest, GivesEachObservationWhenItIsDueWithTheTimeOfNow)
{
    {
        CaptureFile file(log_);
        for (const double stamp_s : {1000.0, 1001.0, 1003.0}) file.write(*scan_at(stamp_s));
        file.flush();
    }
    const double begin_s = unix_time_s();
    play("speed = 10\n");
    const auto played = observations(3);
    ASSERT_EQ(3u, played.size());
    EXPECT_GE(unix_time_s(), begin_s + 0.3);
    EXPECT_NEAR(begin_s, stamp_of(*played[0]), 5);  // a busy machine starts late
    EXPECT_NEAR(0.1, stamp_of(*played[1]) - stamp_of(*played[0]), 1e-6);
    EXPECT_NEAR(0.2, stamp_of(*played[2]) - stamp_of(*played[1]), 1e-6);
    EXPECT_EQ("FRONT", played[2]->sensorLabel);
    EXPECT_FLOAT_EQ(3, dynamic_cast<const CObservation2DRangeScan&>(*played[2]).getScanRange(0));
    player_.doProcess();
    EXPECT_THAT(player_.status().device, testing::HasSubstr("played to its end"));
    EXPECT_EQ("", player_.status().problem);
}

TEST_F(LogPlayerTest, KeepsTheOrderOfArrivalWhereStampsStepBack)
{
    {
        CaptureFile file(log_);
        for (const double stamp_s : {1000.0, 1000.2, 1000.1, 1000.3}) file.write(*scan_at(stamp_s));
        file.flush();
    }
    play("speed = 100\n");
    std::vector<float> order;
    for (const auto& observation : observations(4))
        order.push_back(dynamic_cast<const CObservation2DRangeScan&>(*observation).getScanRange(0));
    EXPECT_THAT(order, testing::Pointwise(testing::FloatEq(), {0.0f, 0.2f, 0.1f, 0.3f}));
}

TEST_F(LogPlayerTest, AScanComesWhenItsSweepIsOver)
{
    {
        CaptureFile file(log_);
        file.write(*timing_record(*scan_at(1000), {1.0}));
        file.write(*scan_at(1000));
        file.flush();
    }
    play("speed = 5\n");
    const auto played = observations(2);
    ASSERT_EQ(2u, played.size());
    const auto timing = read_timing_record(*played[0]);
    ASSERT_TRUE(timing);
    EXPECT_DOUBLE_EQ(0.2, timing->sweep_s);
    EXPECT_EQ(played[0]->timestamp, played[1]->timestamp);
    EXPECT_GE(unix_time_s(), stamp_of(*played[1]) + 0.2);
}

TEST_F(LogPlayerTest, LeavesOutWhatALiveProgramAdded)
{
    {
        CaptureFile file(log_);
        file.write(*dropped_record(*scan_at(1000)));
        file.write(*scan_at(1000));
        mrpt::obs::CObservationRobotPose pose;
        pose.timestamp = mrpt::Clock::fromDouble(1000);
        file.write(pose);
        file.write(*scan_at(1000.5));
        file.flush();
    }
    play("speed = 100\n");
    const auto played = observations(2);
    ASSERT_EQ(2u, played.size());
    EXPECT_FLOAT_EQ(0.5f, dynamic_cast<const CObservation2DRangeScan&>(*played[1]).getScanRange(0));
}

class MotionLog : public LogPlayerTest
{
 protected:
    /// Three times a motion of one metre ahead and a quarter turn, and a scan after it.
    void write(bool motions_have_stamps)
    {
        CaptureFile file(log_);
        for (int i = 0; i < 3; ++i)
        {
            mrpt::obs::CActionRobotMovement2D motion;
            motion.timestamp =
                motions_have_stamps ? mrpt::Clock::fromDouble(1000 + 0.1 * i) : INVALID_TIMESTAMP;
            motion.computeFromOdometry({1, 0, M_PI / 2}, {});
            mrpt::obs::CActionCollection actions;
            actions.insert(motion);
            file.write(actions);
            mrpt::obs::CSensoryFrame frame;
            frame.insert(scan_at(1000 + 0.1 * i));
            file.write(frame);
        }
        file.flush();
    }
    std::vector<mrpt::poses::CPose2D> odometryOf(std::size_t observations_to_come)
    {
        std::vector<mrpt::poses::CPose2D> poses;
        for (const auto& observation : observations(observations_to_come))
            if (const auto* odometry =
                    dynamic_cast<const mrpt::obs::CObservationOdometry*>(observation.get()))
                poses.push_back(odometry->odometry);
        return poses;
    }
};

TEST_F(MotionLog, MotionsAddUpToOdometry)
{
    write(true);
    play("speed = 100\n");
    const auto poses = odometryOf(6);
    ASSERT_EQ(3u, poses.size());
    // A metre ahead, then left; a metre up, then left; a metre back.
    EXPECT_NEAR(1, poses[0].x(), 1e-9);
    EXPECT_NEAR(1, poses[1].y(), 1e-9);
    EXPECT_NEAR(0, poses[2].x(), 1e-9);
    EXPECT_NEAR(1, poses[2].y(), 1e-9);
}

// As in MRPT's localization_demo.rawlog. The first one is before all time, but it counts.
TEST_F(MotionLog, MotionsWithoutStampsComeWithWhatIsBeforeThem)
{
    write(false);
    play("speed = 100\n");
    const auto poses = odometryOf(5);
    ASSERT_EQ(2u, poses.size());
    EXPECT_NEAR(1, poses[0].y(), 1e-9);
    EXPECT_NEAR(0, poses[1].x(), 1e-9);
}

TEST_F(LogPlayerTest, SaysWhatIsWrongWithTheLog)
{
    EXPECT_THROW(play(), LogError);
    const auto message = [this](const char* keys) -> std::string
    {
        try
        {
            play(keys);
        }
        catch (const std::exception& error)  // MRPT makes one of its own of it
        {
            return error.what();
        }
        return "nothing";
    };
    EXPECT_THAT(
        message("sped = 2\n"),
        testing::HasSubstr("section LOG, unknown key 'sped'; did you mean 'speed'?"));
    EXPECT_THAT(message("speed = 0\n"), testing::HasSubstr("must be 0.01 to 100"));
}
}  // namespace
}  // namespace rtob

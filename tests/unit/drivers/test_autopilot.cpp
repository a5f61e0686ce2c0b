// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationIMU.h>
#include <rtob/drivers/autopilot.h>

namespace rtob
{
namespace
{
using namespace mavlink;
using mrpt::obs::CObservationIMU;

const Eigen::Matrix3d small = 1e-4 * Eigen::Matrix3d::Identity();

std::vector<MavlinkFrame> frames_of(const Bytes& bytes)
{
    MavlinkReader reader;
    reader.push(bytes);
    std::vector<MavlinkFrame> frames;
    while (auto frame = reader.take()) frames.push_back(*frame);
    return frames;
}

template <class Message>
std::vector<Message> sent(Autopilot& autopilot)
{
    std::vector<Message> messages;
    for (const auto& frame : frames_of(autopilot.takeBytes()))
        if (const auto message = message_of<Message>(frame)) messages.push_back(*message);
    return messages;
}

template <class Message>
const CObservationIMU& heard(Autopilot& autopilot, const Message& message, double now_s = 100)
{
    static std::vector<mrpt::obs::CObservation::Ptr> kept;
    Sender controller{1, 1, 0};
    autopilot.receive(controller.encode(message), now_s);
    kept = autopilot.takeObservations();
    if (kept.size() != 1) throw std::runtime_error("not one observation");
    return dynamic_cast<const CObservationIMU&>(*kept[0]);
}

TEST(Autopilot, BeatsOnceASecondAndAsksForTheTime)
{
    Autopilot autopilot({});
    std::size_t beats = 0, questions = 0;
    for (double t = 100; t < 104.95; t += 0.01)
    {
        autopilot.poll(t);
        for (const auto& frame : frames_of(autopilot.takeBytes()))
        {
            beats += frame.id == Heartbeat::id;
            questions += frame.id == Timesync::id;
        }
    }
    EXPECT_EQ(5u, beats);
    EXPECT_EQ(10u, questions);
}

TEST(Autopilot, SendsAPoseAScanWithTheScansTime)
{
    AutopilotOptions options;
    options.pose_hz = 0;
    Autopilot autopilot(options);
    autopilot.matched(100.0, {1, 2, 0}, small);
    autopilot.matched(100.1, {1, 2, 0}, small);
    autopilot.matched(100.1, {1, 2, 0}, small);  // the same scan again
    const auto poses = sent<Odometry>(autopilot);
    ASSERT_EQ(2u, poses.size());
    EXPECT_EQ(100'100'000u, poses[1].time_usec);
    EXPECT_FLOAT_EQ(-2, poses[1].y);
}

TEST(Autopilot, CarriesPosesOnToThirtyHertzAndStops)
{
    Autopilot autopilot({});
    autopilot.matched(100.0, {0, 0, 0}, small);
    std::vector<Odometry> poses;
    for (double t = 100.0; t < 102; t += 0.005)
    {
        autopilot.poll(t);
        for (const auto& pose : sent<Odometry>(autopilot)) poses.push_back(pose);
    }
    EXPECT_NEAR(9, static_cast<double>(poses.size()), 1);  // 0.3 s, then it is too old
    for (std::size_t i = 1; i < poses.size(); ++i)
    {
        EXPECT_GT(poses[i].time_usec, poses[i - 1].time_usec);
        EXPECT_GT(poses[i].pose_covariance[0], poses[i - 1].pose_covariance[0]);
    }
}

TEST(Autopilot, SaysNothingOfWhereItIsWhileLost)
{
    AutopilotOptions options;
    options.message = PoseMessage::VisionPositionEstimate;
    Autopilot autopilot(options);
    autopilot.matched(100.0, {0, 0, 0}, small);
    autopilot.lost();
    autopilot.poll(100.1);
    EXPECT_TRUE(sent<VisionPositionEstimate>(autopilot).empty());
    autopilot.matched(100.2, {0, 0, 0}, small);
    autopilot.poll(100.21);
    const auto poses = sent<VisionPositionEstimate>(autopilot);
    ASSERT_EQ(1u, poses.size());
    EXPECT_EQ(1, poses[0].reset_counter);
}

TEST(Autopilot, AnswersQuestionsForTheTime)
{
    Autopilot autopilot({});
    Sender controller{1, 1, 0};
    autopilot.receive(controller.encode(Timesync{0, 77, 0, 0}), 100.5);
    const auto answers = sent<Timesync>(autopilot);
    ASSERT_EQ(1u, answers.size());
    EXPECT_EQ(77, answers[0].ts1);
    EXPECT_EQ(100'500'000'000, answers[0].tc1);
}

TEST(Autopilot, PutsForeignStampsIntoOurTime)
{
    Autopilot autopilot({});
    Sender controller{1, 1, 0};
    // Its clock began at our 90 s; the way takes 2 ms in each direction.
    for (double asked_s = 100; asked_s < 103; asked_s += 0.5)
        autopilot.receive(
            controller.encode(Timesync{
                std::llround(1e9 * (asked_s + 0.002 - 90)), std::llround(1e9 * asked_s), 0, 0}),
            asked_s + 0.004);
    EXPECT_TRUE(autopilot.timeSync().isSynchronised());
    Attitude attitude;
    attitude.time_boot_ms = 12'500;
    attitude.roll = 0.1f;
    const auto& imu = heard(autopilot, attitude, 103);
    EXPECT_NEAR(102.5, mrpt::Clock::toDouble(imu.timestamp), 1e-4);
}

TEST(Autopilot, TurnsAttitudeAndGyroIntoOurFrames)
{
    Autopilot autopilot({});
    Attitude attitude;
    attitude.roll = 0.1f;
    attitude.pitch = 0.2f;
    attitude.yaw = 0.3f;
    attitude.yawspeed = 0.4f;
    const auto& angles = heard(autopilot, attitude);
    EXPECT_NEAR(0.1, angles.get(mrpt::obs::IMU_ROLL), 1e-6);
    EXPECT_NEAR(-0.2, angles.get(mrpt::obs::IMU_PITCH), 1e-6);
    EXPECT_NEAR(-0.3, angles.get(mrpt::obs::IMU_YAW), 1e-6);
    EXPECT_NEAR(-0.4, angles.get(mrpt::obs::IMU_YAW_VEL), 1e-6);
    EXPECT_EQ(100.0, mrpt::Clock::toDouble(angles.timestamp)) << "clocks not known: arrival";

    ScaledImu scaled;
    scaled.zacc = -1000;  // at rest: 1 g upwards, and z points down
    scaled.zgyro = 500;
    const auto& imu = heard(autopilot, scaled);
    EXPECT_NEAR(9.80665, imu.get(mrpt::obs::IMU_Z_ACC), 1e-6);
    EXPECT_NEAR(-0.5, imu.get(mrpt::obs::IMU_YAW_VEL), 1e-6);
}

TEST(Autopilot, MakesASpeedOfOpticalFlow)
{
    Autopilot autopilot({});
    OpticalFlowRad flow;
    flow.integration_time_us = 100'000;
    flow.distance = 2;
    flow.quality = 255;
    flow.integrated_y = 0.05f;      // moving ahead
    flow.integrated_x = -0.02f;     // moving right
    flow.integrated_ygyro = 0.01f;  // of which a part is turning
    const auto& imu = heard(autopilot, flow);
    EXPECT_NEAR((0.05 - 0.01) / 0.1 * 2, imu.get(mrpt::obs::IMU_X_VEL), 1e-5);
    EXPECT_NEAR(-0.02 / 0.1 * 2, imu.get(mrpt::obs::IMU_Y_VEL), 1e-5);
}

TEST(Autopilot, TakesHeightsOnlyFromWhatLooksDown)
{
    Autopilot autopilot({});
    DistanceSensor sensor;
    sensor.min_distance = 10;
    sensor.max_distance = 1000;
    sensor.current_distance = 150;
    sensor.orientation = 25;
    EXPECT_NEAR(1.5, heard(autopilot, sensor).get(mrpt::obs::IMU_ALTITUDE), 1e-9);
    Sender controller{1, 1, 0};
    sensor.orientation = 0;
    autopilot.receive(controller.encode(sensor), 100);
    EXPECT_TRUE(autopilot.takeObservations().empty());
}

TEST(Autopilot, KeepsTheNewestOfSticksAndMotion)
{
    Autopilot autopilot({});
    Sender controller{1, 1, 0};
    ManualControl manual;
    manual.x = 500;
    autopilot.receive(controller.encode(manual), 100);
    LocalPositionNed position;
    position.vx = 0.25F;
    autopilot.receive(controller.encode(position), 101);
    EXPECT_EQ(500, autopilot.news().manual.message.x);
    EXPECT_EQ(100, autopilot.news().manual.time_s);
    EXPECT_TRUE(autopilot.news().manual.isYoungerThan(0.5, 100.4));
    EXPECT_FALSE(autopilot.news().manual.isYoungerThan(0.5, 100.5));
    EXPECT_EQ(0.25F, autopilot.news().position.message.vx);
    EXPECT_FALSE(autopilot.news().rc.isYoungerThan(1e6, 101));  // none came
}

TEST(Autopilot, SaysTextsOfAnyLength)
{
    Autopilot autopilot({});
    autopilot.say(4, std::string(80, 'x'));
    autopilot.say(6, "ok");
    const auto texts = sent<Statustext>(autopilot);
    ASSERT_EQ(2u, texts.size());
    EXPECT_EQ('x', texts[0].text[49]);
    EXPECT_EQ(std::string("ok"), std::string(texts[1].text.data()));
}
}  // namespace
}  // namespace rtob

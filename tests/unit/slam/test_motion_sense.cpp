// SPDX-License-Identifier: BSD-3-Clause
// From MRPT's observations to the guess of a scan's pose.
#include <gmock/gmock.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRange.h>
#include <rtob/slam/motion_sense.h>

#include <cmath>
#include <limits>

#include "near_pose.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double kEpoch_s = 1.6e9;

template <class Observation>
Observation at(double time_s, const char* label)
{
    Observation observation;
    observation.timestamp = mrpt::Clock::fromDouble(kEpoch_s + time_s);
    observation.sensorLabel = label;
    return observation;
}

mrpt::obs::CObservationIMU gyro(double time_s, double rate_radps, const char* label = "IMU")
{
    auto imu = at<mrpt::obs::CObservationIMU>(time_s, label);
    imu.set(mrpt::obs::IMU_WZ, rate_radps);
    return imu;
}

mrpt::obs::CObservationIMU flow(double time_s, double forward_mps, double left_mps)
{
    auto imu = at<mrpt::obs::CObservationIMU>(time_s, "FLOW");
    imu.set(mrpt::obs::IMU_X_VEL, forward_mps);
    imu.set(mrpt::obs::IMU_Y_VEL, left_mps);
    return imu;
}

mrpt::obs::CObservationIMU altitude(double time_s, double height_m)
{
    auto imu = at<mrpt::obs::CObservationIMU>(time_s, "HEIGHT");
    imu.set(mrpt::obs::IMU_ALTITUDE, height_m);
    return imu;
}

mrpt::obs::CObservationOdometry odometry(double time_s, const Pose2& pose)
{
    auto observation = at<mrpt::obs::CObservationOdometry>(time_s, "ODOMETRY");
    observation.odometry = {pose.x, pose.y, pose.yaw};
    return observation;
}

MotionSense sense(PrealignSource source = PrealignSource::Fusion)
{
    return {source, FusionOptions(), ScanGeometryOptions()};
}

void begin(MotionSense& motion, double time_s)
{
    motion.beginScan(kEpoch_s + time_s, at<mrpt::obs::CObservation2DRangeScan>(time_s, "LASER"));
}

/// A scan that finds the vehicle where it was thought to be.
void scan(MotionSense& motion, double time_s)
{
    begin(motion, time_s);
    motion.settle(motion.predicted().pose(), Eigen::Matrix3d::Identity() * 1e-4, true);
}
}  // namespace

TEST(MotionSense, FollowsATurnByTheGyroAlone)
{
    auto motion = sense();
    scan(motion, 0);
    for (int i = 1; i <= 20; ++i) motion.observe(gyro(0.01 * i, 5));
    begin(motion, 0.2);
    // 1 rad in 0.2 s, less what the start at rest takes
    EXPECT_NEAR(motion.predicted().pose().yaw, 1, 0.1);
}

TEST(MotionSense, FollowsFlowAndOdometry)
{
    auto by_flow = sense(), by_odometry = sense();
    scan(by_flow, 0), scan(by_odometry, 0);
    by_odometry.observe(odometry(0.001, {7, 7, 0}));  // in a frame of its own
    for (int i = 1; i <= 20; ++i)
    {
        by_flow.observe(flow(0.01 * i, 1, 0.5));
        by_odometry.observe(odometry(0.01 * i, {7 + 0.01 * i, 7, 0}));
    }
    begin(by_flow, 0.2), begin(by_odometry, 0.2);
    EXPECT_THAT(by_flow.predicted().pose(), IsNearPose(Pose2{0.2, 0.1, 0}, 0.03, 0.05));
    EXPECT_THAT(by_odometry.predicted().pose(), IsNearPose(Pose2{0.2, 0, 0}, 0.01, 0.02));
}

TEST(MotionSense, TakesVelocitiesOfASourceWithoutPoses)
{
    auto motion = sense();
    scan(motion, 0);
    for (int i = 1; i <= 20; ++i)
    {
        auto observation = odometry(0.01 * i, {});
        observation.hasVelocities = true;
        observation.velocityLocal = {1, 0, 0.5};
        motion.observe(observation);
    }
    begin(motion, 0.2);
    EXPECT_THAT(motion.predicted().pose(), IsNearPose(Pose2{0.2, 0, 0.1}, 0.03, 0.03));
}

/// Actions of rawlogs have no time: they count for the scan that follows.
TEST(MotionSense, AddsUpTheMotionsOfActions)
{
    auto motion = sense();
    motion.addMotion({5, 0, 0});  // before the first scan: no part of the map
    scan(motion, 0);
    motion.addMotion({0.1, 0, 0});
    motion.addMotion({0.1, 0, 0.2});
    begin(motion, 0.25);
    EXPECT_THAT(motion.predicted().pose(), IsNearPose(Pose2{0.2, 0, 0.2}, 0.02, 0.03));
}

TEST(MotionSense, DecidesByItselfOnlyWhereThereIsGyroOrFlow)
{
    auto motion = sense(PrealignSource::Auto);
    EXPECT_FALSE(motion.decides());
    motion.observe(odometry(0, {}));
    EXPECT_FALSE(motion.decides());
    motion.observe(gyro(0, 0.1));
    EXPECT_TRUE(motion.decides());
    auto plain = sense(PrealignSource::ConstantVelocity);
    plain.observe(gyro(0, 0.1));
    EXPECT_FALSE(plain.decides());
}

/// The same device under two names would count twice; when the first dies, the second is there.
TEST(MotionSense, UsesOneGyroUntilItDies)
{
    auto motion = sense();
    scan(motion, 0);
    for (int i = 1; i <= 400; ++i)
    {
        if (i <= 100) motion.observe(gyro(0.01 * i, 0, "FIRST"));
        motion.observe(gyro(0.01 * i, 0.5, "SECOND"));
        if (i % 20 == 0) scan(motion, 0.01 * i);
    }
    const auto& watch = motion.watch(MotionSensor::Gyro);
    EXPECT_GT(watch.readings(), 250U);
    EXPECT_LT(watch.readings(), 350U);
    EXPECT_NEAR(watch.longestGap(), 0, 1.2);
}

TEST(MotionSense, CountsReadingsThatTheFilterDoesNotNeed)
{
    auto motion = sense(PrealignSource::Auto);
    for (int i = 1; i <= 100; ++i)
    {
        motion.observe(odometry(0.1 * i, {3, 2, 1}));
        scan(motion, 0.1 * i);
    }
    const auto& watch = motion.watch(MotionSensor::Odometry);
    EXPECT_EQ(watch.readings(), 100U);
    EXPECT_EQ(watch.with(ReadingFate::NotFused), 100U);
    EXPECT_EQ(motion.complaint(MotionSensor::Odometry), "") << "it stands";
}

TEST(MotionSense, RefusesWhatCannotBe)
{
    auto motion = sense();
    scan(motion, 0);
    motion.observe(gyro(0.01, nan));
    motion.observe(flow(0.01, 1, nan));
    motion.observe(odometry(0.01, {nan, 0, 0}));
    motion.observe(altitude(0.01, 1));
    motion.observe(altitude(0.02, 101));
    motion.settle({1, 2, 3}, Eigen::Matrix3d::Identity() * -1, true);
    motion.settle({1, 2, 3}, Eigen::Matrix3d::Constant(nan), true);
    begin(motion, 0.1);
    EXPECT_THAT(motion.predicted().pose(), IsNearPose(Pose2{}, 1e-6, 1e-6));
    for (const auto sensor : {MotionSensor::Gyro, MotionSensor::Flow, MotionSensor::Odometry})
        EXPECT_EQ(motion.watch(sensor).with(ReadingFate::NotFinite), 1U);
    EXPECT_EQ(motion.watch(MotionSensor::Altimeter).with(ReadingFate::Implausible), 1U);
    EXPECT_EQ(motion.watch(MotionSensor::Scans).with(ReadingFate::BadCovariance), 2U);
    EXPECT_THAT(motion.complaint(MotionSensor::Altimeter), HasSubstr("1 of 2 readings are impos"));
}

/// Stamps of real scans repeat, step back, jump and are missing: the guess stays near the last
/// pose.
TEST(MotionSense, SurvivesBadStampsOfScans)
{
    for (const double stamp_s : {0.2, 0.1, -500.0, 1e6, nan})
    {
        auto motion = sense();
        scan(motion, 0);
        motion.observe(gyro(0.1, 0));
        begin(motion, 0.2);
        motion.settle({1, 2, 0.3}, Eigen::Matrix3d::Identity() * 1e-6, true);
        motion.beginScan(kEpoch_s + stamp_s, mrpt::obs::CObservation2DRangeScan());
        const Pose2 pose = motion.predicted().pose();
        EXPECT_TRUE(std::isfinite(pose.x)) << stamp_s;
        EXPECT_LT(std::hypot(pose.x - 1, pose.y - 2), 2.5) << stamp_s;
        EXPECT_TRUE(motion.predicted().covariance.allFinite()) << stamp_s;
    }
}

TEST(MotionSense, LevelsByTheAttitudeAtTheScansTime)
{
    auto motion = sense();
    for (int i = 0; i <= 10; ++i)
    {
        auto imu = gyro(0.01 * i, 0);
        imu.set(mrpt::obs::IMU_ROLL, 0.01 * i);
        imu.set(mrpt::obs::IMU_PITCH, -0.02 * i);
        motion.observe(imu);
    }
    begin(motion, 0.055);
    const auto geometry = motion.geometry(mrpt::poses::CPose3D(), {});
    EXPECT_NEAR(geometry.pose_level_laser.roll(), 0.055, 1e-6);
    EXPECT_NEAR(geometry.pose_level_laser.pitch(), -0.11, 1e-6);
    begin(motion, 5);  // too old to say anything
    EXPECT_EQ(motion.geometry(mrpt::poses::CPose3D(), {}).pose_level_laser.roll(), 0);
}

TEST(MotionReadings, KnowAGyroThatHangs)
{
    auto imu = gyro(0, 0.5);
    imu.sensorPose = mrpt::poses::CPose3D(0, 0, 0, 0, 0, M_PI);
    EXPECT_NEAR(*yaw_rate_in(imu), -0.5, 1e-12);
}

/// Turned by 90 degrees to the left, the sensor's roll is the vehicle's pitch.
TEST(MotionReadings, KnowATurnedAttitudeSensor)
{
    auto imu = gyro(0, 0);
    imu.set(mrpt::obs::IMU_ROLL, 0.2);
    imu.set(mrpt::obs::IMU_PITCH, 0.0);
    imu.sensorPose = mrpt::poses::CPose3D(0, 0, 0, M_PI / 2, 0, 0);
    const auto tilt = tilt_in(imu);
    ASSERT_TRUE(tilt);
    EXPECT_NEAR(tilt->roll_rad, 0, 1e-9);
    EXPECT_NEAR(tilt->pitch_rad, 0.2, 1e-9);
}

TEST(MotionReadings, TakeNoInertialSystemForOpticalFlow)
{
    EXPECT_TRUE(flow_in(flow(0, 1, 2)));
    auto inertial = flow(0, 1, 2);
    inertial.set(mrpt::obs::IMU_ROLL, 0);
    EXPECT_FALSE(flow_in(inertial));
}

TEST(MotionReadings, ReadHeightsOfRangesThatLookDown)
{
    auto range = at<mrpt::obs::CObservationRange>(0, "ALTIMETER");
    mrpt::obs::CObservationRange::TMeasurement measurement;
    measurement.sensedDistance = 1.5F;
    range.sensedData.push_back(measurement);  // looks ahead
    EXPECT_FALSE(height_in(range));
    measurement.sensorPose = {0, 0, -0.1, 0, M_PI / 2, 0};
    range.sensedData.push_back(measurement);
    EXPECT_NEAR(*height_in(range), 1.6, 1e-6);
}
}  // namespace rtob::test

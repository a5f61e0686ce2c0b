// SPDX-License-Identifier: BSD-3-Clause
// The filter with its default options on flights that do not follow its model: a multirotor in
// gusts that flies, stops and turns, sensors with scale errors and biases. It may be more careful
// than it need be, never more sure than it is.
#include <gtest/gtest.h>
#include <rtob/sim/motion_sensors.h>

#include <cmath>
#include <vector>

#include "motion_run.h"

namespace rtob::test
{
namespace
{
constexpr int kRuns = 100;
constexpr double kDuration_s = 20, kStep_s = 0.01, kRad = MotionRun::kRad;
constexpr double kScan_s = 0.2, kScanSigma_m = 0.01, kScanSigma_rad = 0.2 * kRad;

struct Case
{
    const char* name;
    bool gyro, flow, odometry;
};

/// Another command each 2 s.
sim::VelocityCommand command_at(double time_s, std::uint64_t seed)
{
    const double phase = static_cast<double>(seed) + std::floor(time_s / 2);
    return {
        1.5 * std::sin(1.7 * phase), 0.5 * std::sin(2.9 * phase), 1.5 * std::sin(4.1 * phase), 0};
}

Measurement reading(
    Measurement::Kind kind, double time_s, const Eigen::Vector3d& value,
    const Eigen::Vector3d& sigma)
{
    return {kind, time_s, value, sigma.cwiseAbs2().asDiagonal()};
}

/// As rtob-slam tells the filter of it.
Measurement way_reading(
    double time_s, const Pose2& way, bool has_begun, const FusionOptions& options)
{
    const double way_m = std::hypot(way.x, way.y);
    const double sigma_m = 0.001 + options.odometry_noise_m * std::sqrt(way_m);
    const double sigma_rad =
        0.001 + options.odometry_noise_deg * kRad * std::sqrt(way_m + std::abs(way.yaw) / 1.57);
    return reading(
        has_begun ? Measurement::Kind::Way : Measurement::Kind::WayBegin, time_s,
        {way.x, way.y, way.yaw}, {sigma_m, sigma_m, sigma_rad});
}

class Flight
{
 public:
    Flight(const Case& sensors, std::uint64_t seed)
        : case_(sensors),
          seed_(seed),
          vehicle_(vehicleOptions(), {0, 0, 1, 0, 0, 0}, seed),
          sensors_({}, {0, 0, 1, 0, 0, 0}, seed),
          noise_(seed, 99),
          filter_(options_)
    {
        filter_.start(0, {}, Eigen::Matrix3d::Identity() * 1e-6);
    }

    /// To the next scan. @return NEES of the pose before it (3 degrees of freedom)
    double toNextScan()
    {
        for (int i = 0; i < std::lround(kScan_s / kStep_s); ++i)
        {
            vehicle_.step(kStep_s, command_at(time_s_, seed_));
            sensors_.observe(time_s_ += kStep_s, vehicle_.state());
        }
        addReadings();
        const Pose2 truth = vehicle_.state().pose_map_vehicle.from_above();
        const MotionState state = filter_.at(time_s_);
        const Eigen::Vector3d error(
            truth.x - state.mean[kX], truth.y - state.mean[kY],
            wrap_angle(truth.yaw - state.mean[kYaw]));
        filter_.addPose(reading(
            Measurement::Kind::Pose, time_s_,
            {truth.x + noise_.gaussian(kScanSigma_m), truth.y + noise_.gaussian(kScanSigma_m),
             truth.yaw + noise_.gaussian(kScanSigma_rad)},
            {kScanSigma_m, kScanSigma_m, kScanSigma_rad}));
        return error.dot(state.poseCovariance().ldlt().solve(error));
    }

 private:
    static sim::VehicleOptions vehicleOptions()
    {
        sim::VehicleOptions options;
        options.turbulence_mps2 = 0.45;
        options.yaw_turbulence_dps2 = 30;
        return options;
    }

    void addReadings()
    {
        const auto readings = sensors_.takeReadings();
        if (case_.gyro)
            for (const auto& imu : readings.imu)
                filter_.add(reading(
                    Measurement::Kind::YawRate, imu.time_s, {imu.yaw_rate_radps, 0, 0},
                    {options_.gyro_noise_degps * kRad, 1, 1}));
        if (case_.flow)
            for (const auto& flow : readings.flow)
            {
                const double sigma =
                    options_.flow_noise_mps +
                    options_.flow_scale_error * std::hypot(flow.forward_mps, flow.left_mps);
                filter_.add(reading(
                    Measurement::Kind::Velocity, flow.time_s, {flow.forward_mps, flow.left_mps, 0},
                    {sigma, sigma, 1}));
            }
        if (!case_.odometry) return;
        for (const auto& odometry : readings.odometry)
        {
            filter_.add(way_reading(
                odometry.time_s, between(pose_odom_last_, odometry.pose_odom_vehicle), has_begun_,
                options_));
            pose_odom_last_ = odometry.pose_odom_vehicle;
            has_begun_ = true;
        }
    }

    Case case_;
    std::uint64_t seed_;
    FusionOptions options_;
    sim::Vehicle vehicle_;
    sim::MotionSensors sensors_;
    sim::Noise noise_;
    MotionFilter filter_;
    Pose2 pose_odom_last_;
    bool has_begun_ = false;
    double time_s_ = 0;
};

class SimulatedFlights : public testing::TestWithParam<Case>
{
};
}  // namespace

TEST_P(SimulatedFlights, AreNoFartherOffThanTheFilterSays)
{
    const int scans = static_cast<int>(kDuration_s / kScan_s);
    std::vector<double> sums(static_cast<std::size_t>(scans), 0);
    for (int run = 1; run <= kRuns; ++run)
    {
        Flight flight(GetParam(), static_cast<std::uint64_t>(run));
        for (double& sum : sums) sum += flight.toNextScan();
    }
    // 97.5 % quantile of the mean of 100 chi-square variables of 3 degrees of freedom
    constexpr double upper_bound = 3.499;
    double below = 0, mean = 0;
    for (const double sum : sums)
    {
        below += sum / kRuns <= upper_bound;
        mean += sum / kRuns / scans;
    }
    RecordProperty("mean_nees", std::to_string(mean));
    EXPECT_GE(below / scans, 0.9) << "mean NEES " << mean;
    EXPECT_GT(mean, 0.03) << "so careful that it says nothing";
}

INSTANTIATE_TEST_SUITE_P(
    WithAndWithoutEachSensor, SimulatedFlights,
    testing::Values(
        Case{"All", true, true, true}, Case{"NoGyro", false, true, true},
        Case{"NoFlow", true, false, true}, Case{"NoOdometry", true, true, false},
        Case{"ScansOnly", false, false, false}),
    [](const auto& test) { return test.param.name; });
}  // namespace rtob::test

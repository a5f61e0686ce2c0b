// SPDX-License-Identifier: BSD-3-Clause
// Fails when `rtob-slam run` with its default options becomes less accurate on short logs.
//
// The golden values were measured with the commit that brought this file in: the worst of the seeds
// 1 to 10 (RTOB_GUARD_SEED=N runs another seed than the default). A change of them needs its reason
// in the commit's message: what was gained for it, and the figures of docs/evaluation.md before and
// after. They are not there to be adjusted until the test passes; smaller ones are welcome.
#include <gmock/gmock.h>
#include <rtob/eval/relations.h>
#include <rtob/eval/trajectory_score.h>
#include <rtob/io/pose_file.h>

#include <cstdlib>
#include <filesystem>

#include "house.h"
#include "rtob_slam_run.h"

namespace rtob::test
{
namespace
{
/// Beyond the worst of ten seeds. Another compiler or an innocent change draws other points, which
/// is one more seed, not a worse method.
constexpr double kMargin = 1.15;

struct Accuracy
{
    double distance_m = 0;
    double turn_deg = 0;
};

class AccuracyGuard : public RunFixture
{
 protected:
    /// The online trajectory, with the seed that was asked for or 1.
    std::vector<StampedPose2> trajectory_of(
        const std::string& log, const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> flags{"--quiet", "--overwrite"};
        flags.insert(flags.end(), more.begin(), more.end());
        const char* const seed = std::getenv("RTOB_GUARD_SEED");
        if (seed != nullptr) flags.insert(flags.end(), {"--seed", seed});
        const auto result = run(log, flags);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return trajectory();
    }

    static Accuracy absolute_accuracy(
        const std::vector<StampedPose2>& estimate, const std::vector<StampedPose2>& truth)
    {
        const auto score = score_trajectory(estimate, truth);
        EXPECT_EQ(score.matches.size(), estimate.size());
        return {score.absolute.distance_m.rmse, score.absolute.turn_deg.rmse};
    }

    static void expect_no_worse(const Accuracy& now, const Accuracy& golden)
    {
        EXPECT_LE(now.distance_m, kMargin * golden.distance_m) << "m";
        EXPECT_LE(now.turn_deg, kMargin * golden.turn_deg) << "degrees";
    }
};

/// Two laps of a figure of eight through two rooms, 40 m: ranges with 1 cm of noise, wheels that
/// measure 3 % too short and turn 8 % too far, as cheap ones do.
TEST_F(AccuracyGuard, TwoRoomsWithBadOdometry)
{
    LogObjects objects;
    std::vector<StampedPose2> truth;
    Random random(1);
    Pose2 pose_odom_vehicle;
    for (int k = 0; k < 2 * house_lap_scans; ++k)
    {
        const auto scan = noisy_scan_in_house(k, 0.01, random);
        truth.push_back({mrpt::Clock::toDouble(scan.timestamp), pose_in_house(k)});
        auto step = k > 0 ? between(pose_in_house(k - 1), pose_in_house(k)) : Pose2{};
        step = {0.97 * step.x, 0.97 * step.y, 1.08 * step.yaw};
        pose_odom_vehicle = compose(pose_odom_vehicle, step);
        auto odometry = mrpt::obs::CObservationOdometry::Create();
        odometry->timestamp = scan.timestamp;
        odometry->odometry = {pose_odom_vehicle.x, pose_odom_vehicle.y, pose_odom_vehicle.yaw};
        objects.push_back(odometry);
        objects.push_back(mrpt::obs::CObservation2DRangeScan::Create(scan));
    }
    const auto estimate = trajectory_of(write_log("house.rawlog", objects));
    expect_no_worse(absolute_accuracy(estimate, truth), {0.00224, 0.0447});
}

/// Debian's mrpt-common: a simulated office with exact poses beside the log. The first 600 scans.
TEST_F(AccuracyGuard, MrptsSimulatedOffice)
{
    const std::string log =
        "/usr/share/mrpt/datasets/graphslam-engine-demos/action_observations_map/simul.rawlog";
    if (!std::filesystem::exists(log)) GTEST_SKIP() << log << " is missing (package mrpt-common)";
    const auto estimate = trajectory_of(log, {"--first", "600"});
    expect_no_worse(absolute_accuracy(estimate, read_poses(log)), {0.0504, 0.357});
}

/// The beginning of a real log against its hand-checked relations.
TEST_F(AccuracyGuard, TheFirstRoomsOfFr079)
{
    const char* const datasets = std::getenv("RTOB_DATASETS");
    if (datasets == nullptr) GTEST_SKIP() << "RTOB_DATASETS is not set";
    const std::string fr079 = std::string(datasets) + "/fr079/fr079";
    const auto estimate = trajectory_of(fr079 + ".clf.bz2", {"--first", "800"});
    const auto errors = relation_errors(estimate, read_relations(fr079 + ".relations.gz"));
    EXPECT_GT(errors.residuals.size(), 100U);
    expect_no_worse({errors.distance_m.mean, errors.turn_deg.mean}, {0.0220, 0.284});
}
}  // namespace
}  // namespace rtob::test

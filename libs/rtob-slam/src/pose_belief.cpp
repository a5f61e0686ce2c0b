// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <rtob/slam/pose_belief.h>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace rtob
{
namespace
{
// What of the local map is the newest scan. Matches of many scans share the map's errors and drag
// behind a little, so the share is larger than that of the points that are drawn.
constexpr double kNewestShare = 0.3;
// A velocity that nobody has measured for so long says nothing any more.
constexpr double kVelocityLasts_s = 10;
// Standing wheels slip this much, one sigma a step.
constexpr double kLeastWay_m = 0.002, kLeastTurn_deg = 0.05;
// The variance of a pose of which nothing is known, beside any match's.
constexpr double kAnywhere = 1e4;
// Where the state's parts begin.
constexpr int kPose = 0, kVelocity = 3, kLocalMap = 6;

double square(double value)
{
    return value * value;
}

/// Of x, y, yaw.
Eigen::Vector3d variances(double metres, double degrees)
{
    return {square(metres), square(metres), square(mrpt::DEG2RAD(degrees))};
}
}  // namespace

PoseBelief::PoseBelief(const FusionOptions& noises) : noises_(noises)
{
    begin();
}

Eigen::Vector3d PoseBelief::change() const
{
    return variances(noises_.speed_change_mps, noises_.turn_change_degps);
}

void PoseBelief::begin()
{
    p_.setZero();
    p_.diagonal().segment<3>(kVelocity) = change();
}

void PoseBelief::forget(const Eigen::Matrix3d& covariance_map)
{
    begin();
    p_.diagonal().segment<3>(kPose).setConstant(kAnywhere);
    p_.block<3, 3>(kLocalMap, kLocalMap) = covariance_map;
}

void PoseBelief::advance(double step_s, const Eigen::Vector2d& way_map, bool by_odometry)
{
    if (!by_odometry) p_.diagonal().segment<3>(kVelocity) += change() * step_s;
    State moved = State::Identity();
    moved.block<3, 3>(kPose, kVelocity).diagonal().setConstant(by_odometry ? 0 : step_s);
    moved.block<3, 3>(kVelocity, kVelocity)
        .diagonal()
        .setConstant(by_odometry ? 0 : std::exp(-step_s / kVelocityLasts_s));
    for (const int frame : {kPose, kLocalMap})  // what an error of yaw makes of the way
    {
        moved(frame, frame + 2) = -way_map.y();
        moved(frame + 1, frame + 2) = way_map.x();
    }
    p_ = moved * p_ * moved.transpose();
    if (!by_odometry) return;
    p_.diagonal().segment<3>(kPose) +=
        variances(kLeastWay_m, kLeastTurn_deg) +
        variances(noises_.odometry_noise_m, noises_.odometry_noise_deg) * way_map.norm();
    p_.diagonal().segment<3>(kVelocity) = change();  // should odometry end here
}

void PoseBelief::matched(const Eigen::Matrix3d& covariance)
{
    Seen seen = Seen::Zero();
    seen.middleCols<3>(kPose).setIdentity();
    seen.middleCols<3>(kLocalMap).diagonal().setConstant(-1);
    update(seen, covariance);
}

void PoseBelief::held(const Eigen::Matrix3d& covariance, const Eigen::Matrix3d& covariance_old)
{
    Seen seen = Seen::Zero();
    seen.middleCols<3>(kPose).setIdentity();
    update(seen, covariance + covariance_old);
    raiseTo(covariance_old);
}

/// Pose and local map may be off together by at least as much.
void PoseBelief::raiseTo(const Eigen::Matrix3d& least)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> lacking(least - inMap());
    const Eigen::Matrix3d more = lacking.eigenvectors() *
                                 lacking.eigenvalues().cwiseMax(0).asDiagonal() *
                                 lacking.eigenvectors().transpose();
    for (const int a : {kPose, kLocalMap})
        for (const int b : {kPose, kLocalMap}) p_.block<3, 3>(a, b) += more;
}

void PoseBelief::update(const Seen& seen, const Eigen::Matrix3d& covariance)
{
    const Eigen::Matrix3d spread = seen * p_ * seen.transpose() + covariance;
    const Eigen::Matrix<double, 9, 3> gain = spread.ldlt().solve(seen * p_).transpose();
    // Joseph's form stays positive, however certain the match.
    const State left = State::Identity() - gain * seen;
    p_ = left * p_ * left.transpose() + gain * covariance * gain.transpose();
}

void PoseBelief::inserted()
{
    State mixed = State::Identity();
    mixed.block<3, 3>(kLocalMap, kPose).diagonal().setConstant(kNewestShare);
    mixed.block<3, 3>(kLocalMap, kLocalMap).diagonal().setConstant(1 - kNewestShare);
    p_ = mixed * p_ * mixed.transpose();
}

Eigen::Matrix3d PoseBelief::inLocalMap() const
{
    const auto pose_and_map = p_.block<3, 3>(kPose, kLocalMap);
    return inMap() + p_.block<3, 3>(kLocalMap, kLocalMap) - pose_and_map - pose_and_map.transpose();
}
}  // namespace rtob

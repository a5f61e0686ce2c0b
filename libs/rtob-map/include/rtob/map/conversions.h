// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/maps/CPointsMap.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>
#include <Eigen/Core>

#include <limits>

/// Poses, points and stamps between the core and MRPT. All SI; yaw wrapped into [-pi, pi).
namespace rtob
{
[[nodiscard]] inline Pose2 to_pose2(const mrpt::math::TPose2D& pose)
{
    return {pose.x, pose.y, wrap_angle(pose.phi)};
}

[[nodiscard]] inline Pose2 to_pose2(const mrpt::poses::CPose2D& pose)
{
    return {pose.x(), pose.y(), wrap_angle(pose.phi())};
}

[[nodiscard]] inline mrpt::math::TPose2D to_tpose2d(const Pose2& pose)
{
    return {pose.x, pose.y, pose.yaw};
}

[[nodiscard]] inline mrpt::poses::CPose2D to_cpose2d(const Pose2& pose)
{
    return {pose.x, pose.y, pose.yaw};
}

/// @param covariance of x, y, yaw; m^2, rad^2.
[[nodiscard]] inline mrpt::poses::CPosePDFGaussian to_pdf(
    const Pose2& pose, const Eigen::Matrix3d& covariance)
{
    return {to_cpose2d(pose), mrpt::math::CMatrixDouble33(covariance)};
}

/// UNIX time [s]; not a number where the observation has none.
[[nodiscard]] inline double stamp_of(const mrpt::obs::CObservation& observation)
{
    return observation.timestamp == INVALID_TIMESTAMP
               ? std::numeric_limits<double>::quiet_NaN()
               : mrpt::Clock::toDouble(observation.timestamp);
}

/// The map's own x and y; valid until the map changes.
[[nodiscard]] inline PointsView view_of(const mrpt::maps::CPointsMap& points)
{
    return {
        points.getPointsBufferRef_x().data(), points.getPointsBufferRef_y().data(), points.size()};
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <cstddef>
#include <string>
#include <vector>

/// Accuracy without a global truth: how well a trajectory agrees with relative poses that people
/// checked by hand. Kuemmerle et al., "On measuring the accuracy of SLAM algorithms", Autonomous
/// Robots 27(4), 2009.
namespace rtob
{
/// The true pose of the vehicle at t2 seen from the vehicle at t1.
struct Relation
{
    double t1_s = 0;
    double t2_s = 0;
    Pose2 pose_1_2;
};

/// Reads lines `t1 t2 x y z roll pitch yaw` (s, m, rad), plain or packed by gzip or bzip2; empty
/// lines and lines that start with # are skipped. Throws std::runtime_error that names file and
/// line for anything else, a motion out of the plane included.
[[nodiscard]] std::vector<Relation> read_relations(const std::string& file);

/// The part of a trajectory's motion from t1 to t2 that the relation does not explain:
/// inverse(pose_1_2) composed with the estimate of pose_1_2.
struct RelationResidual
{
    std::size_t relation = 0;  ///< its index in the list
    double distance_m = 0;     ///< length of the residual's translation
    double turn_deg = 0;       ///< size of the residual's rotation, [0, 180]
    std::size_t pose_1 = 0;    ///< the poses at t1 and t2, indices in the trajectory
    std::size_t pose_2 = 0;
};

struct MeanStd
{
    double mean = 0;
    double std = 0;  ///< of the values themselves (divided by n)
};

struct RelationErrors
{
    MeanStd distance_m;  ///< the usual figure
    MeanStd squared_distance_m2;
    MeanStd turn_deg;
    MeanStd squared_turn_deg2;
    std::vector<RelationResidual> residuals;  ///< of the matched relations, in their order
    std::size_t unmatched_relations = 0;      ///< that name a time at which no pose is
};

/// Compares a trajectory, in any order of time, with relations. A relation's time means the pose
/// with the nearest stamp, at most 0.1 ms away: far less than between two scans, far more than the
/// rounding of stamps that were written with six decimals. Where poses share a stamp, the first
/// counts. Throws std::runtime_error when no relation matches, or when a pose that is needed is not
/// finite.
[[nodiscard]] RelationErrors relation_errors(
    const std::vector<StampedPose2>& trajectory, const std::vector<Relation>& relations);

/// The `count` residuals of the largest distance, the worst first.
[[nodiscard]] std::vector<RelationResidual> worst_residuals(
    const RelationErrors& errors, std::size_t count);
}  // namespace rtob

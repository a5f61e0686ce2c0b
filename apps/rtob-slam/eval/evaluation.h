// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/eval/map_agreement.h>
#include <rtob/eval/relations.h>
#include <rtob/eval/trajectory_score.h>

#include <string>
#include <variant>
#include <vector>

namespace rtob
{
/// A trajectory against relations.
struct RelationEvaluation
{
    std::vector<StampedPose2> estimate;
    std::vector<Relation> relations;
    RelationErrors errors;
};

/// A trajectory against another one.
struct TrajectoryEvaluation
{
    std::vector<StampedPose2> estimate;
    std::vector<StampedPose2> reference;
    ScoreOptions options;
    TrajectoryScore score;
};

/// A map against another one of the same place.
struct MapEvaluation
{
    Points points_estimate;   ///< as laid onto the reference
    Points points_reference;  ///< in its own map frame, as the above
    MapAgreementOptions options;
    MapAgreement agreement;
};

using Evaluation = std::variant<RelationEvaluation, TrajectoryEvaluation, MapEvaluation>;

/// Finds out what the reference is and compares; the options are for trajectories. Throws
/// std::runtime_error that names the files.
[[nodiscard]] Evaluation evaluate(
    const std::string& estimate_file, const std::string& reference_file,
    const ScoreOptions& options);

/// The same for two PLY files.
[[nodiscard]] MapEvaluation evaluate_maps(
    const std::string& estimate_file, const std::string& reference_file);
}  // namespace rtob

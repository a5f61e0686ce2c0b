// SPDX-License-Identifier: BSD-3-Clause
#pragma once
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

using Evaluation = std::variant<RelationEvaluation, TrajectoryEvaluation>;

/// Finds out what the reference is and compares; the options are for trajectories. Throws
/// std::runtime_error that names the files.
[[nodiscard]] Evaluation evaluate(
    const std::string& estimate_file, const std::string& reference_file,
    const ScoreOptions& options);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "eval/evaluation.h"

#include <rtob/io/pose_file.h>

#include <stdexcept>

namespace rtob
{
namespace
{
/// Calls, and names the two files where what they hold does not go together.
template <class Compare>
auto compared(
    const std::string& estimate_file, const std::string& reference_file, Compare&& compare)
{
    try
    {
        return compare();
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error(
            estimate_file + " against " + reference_file + ": " + error.what() + ".");
    }
}
}  // namespace

Evaluation evaluate(
    const std::string& estimate_file, const std::string& reference_file,
    const ScoreOptions& options)
{
    const auto estimate = read_poses(estimate_file);
    if (pose_file_kind(reference_file) == PoseFileKind::Relations)
    {
        const auto relations = read_relations(reference_file);
        const auto errors = compared(
            estimate_file, reference_file, [&] { return relation_errors(estimate, relations); });
        return RelationEvaluation{estimate, relations, errors};
    }
    const auto reference = read_poses(reference_file);
    const auto score = compared(
        estimate_file, reference_file,
        [&] { return score_trajectory(estimate, reference, options); });
    return TrajectoryEvaluation{estimate, reference, options, score};
}
}  // namespace rtob

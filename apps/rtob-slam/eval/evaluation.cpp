// SPDX-License-Identifier: BSD-3-Clause
#include "eval/evaluation.h"

#include <rtob/io/pose_file.h>

#include <cmath>
#include <stdexcept>

#include "eval/map_file.h"

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

void move(Points& points, const Pose2& pose)
{
    const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double x = points.x[i], y = points.y[i];
        points.x[i] = static_cast<float>(pose.x + c * x - s * y);
        points.y[i] = static_cast<float>(pose.y + s * x + c * y);
    }
}
}  // namespace

MapEvaluation evaluate_maps(const std::string& estimate_file, const std::string& reference_file)
{
    MapEvaluation maps;
    maps.points_estimate = read_ply_points(estimate_file);
    maps.points_reference = read_ply_points(reference_file);
    maps.agreement =
        map_agreement(maps.points_estimate.view(), maps.points_reference.view(), maps.options);
    move(maps.points_estimate, maps.agreement.pose_reference_estimate);
    return maps;
}

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

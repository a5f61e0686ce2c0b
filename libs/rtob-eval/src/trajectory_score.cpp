// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/trajectory_score.h>

namespace rtob
{
TrajectoryScore score_trajectory(
    const std::vector<StampedPose2>& estimate, const std::vector<StampedPose2>& reference,
    const ScoreOptions& options)
{
    TrajectoryScore score;
    score.estimate_poses = estimate.size();
    score.reference_poses = reference.size();
    const auto matches = match_by_time(estimate, reference, options.max_difference_s);
    score.pose_reference_estimate = alignment_of(matches, options.alignment);
    score.matches = moved_estimates(matches, score.pose_reference_estimate);
    score.absolute = absolute_errors(score.matches);
    for (const auto& relative : options.relative)
        score.relative.push_back(relative_errors(score.matches, relative));
    return score;
}
}  // namespace rtob

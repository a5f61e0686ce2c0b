// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/eval/alignment.h>
#include <rtob/eval/trajectory_errors.h>

#include <cstddef>
#include <vector>

namespace rtob
{
struct ScoreOptions
{
    double max_difference_s = 0.01;  ///< between the stamps of poses that match
    Alignment alignment = Alignment::Se2;
    std::vector<RelativeErrorOptions> relative =
        std::vector<RelativeErrorOptions>(1);  ///< an RPE each; may be empty
};

struct TrajectoryScore
{
    std::size_t estimate_poses = 0;
    std::size_t reference_poses = 0;
    Pose2 pose_reference_estimate;   ///< the alignment: takes the estimate to the reference's map
    std::vector<PoseMatch> matches;  ///< the estimates aligned
    PoseErrors absolute;
    std::vector<PoseErrors> relative;  ///< as the options ask, in their order
};

/// Matches, aligns and compares: all that is needed for a row of a table. Throws what its parts
/// throw: std::runtime_error for data, std::invalid_argument for options.
[[nodiscard]] TrajectoryScore score_trajectory(
    const std::vector<StampedPose2>& estimate, const std::vector<StampedPose2>& reference,
    const ScoreOptions& options = {});
}  // namespace rtob

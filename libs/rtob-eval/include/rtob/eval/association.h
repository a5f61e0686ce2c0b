// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <cstddef>
#include <vector>

namespace rtob
{
/// An estimated pose and the reference pose of the same moment. Each is the vehicle seen from its
/// own map; the two maps need not agree.
struct PoseMatch
{
    std::size_t estimate_index = 0;  ///< in the trajectory that was matched
    std::size_t reference_index = 0;
    double time_s = 0;  ///< of the estimate
    Pose2 estimate;
    Pose2 reference;
};

/// Matches poses by their stamps as evo does: each pose of the shorter trajectory (the estimate,
/// when both are as long) goes with the nearest stamp of the other one, at most `max_difference_s`
/// away; of two stamps equally near, the earlier.
///
/// Unlike evo, no pose is used twice: the nearest claim wins. Where stamps repeat on both sides the
/// first goes with the first and the second with the second. Stamps may step back; the matches come
/// in the order of the estimate's poses, as the order of a log is right where its stamps are not.
///
/// Throws std::runtime_error when a trajectory is empty, a stamp or a matched pose is not finite,
/// or no stamps match; std::invalid_argument for a negative difference.
[[nodiscard]] std::vector<PoseMatch> match_by_time(
    const std::vector<StampedPose2>& estimate, const std::vector<StampedPose2>& reference,
    double max_difference_s = 0.01);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/eval/association.h>
#include <rtob/eval/error_statistics.h>
#include <rtob/eval/steps.h>

#include <vector>

/// How far an estimated trajectory is from a reference, as evo defines it.
namespace rtob
{
/// What a residual motion, which would be the identity for the truth, amounts to.
struct PoseError
{
    std::size_t match = 0;  ///< the (later) pose's index in the list of matches
    double distance_m = 0;
    double turn_deg = 0;  ///< [0, 180]
    double full = 0;      ///< Frobenius norm of (motion - identity) as 4x4 matrices; no unit
};

struct PoseErrors
{
    std::vector<PoseError> errors;
    ErrorStatistics distance_m, turn_deg, full;
};

/// ATE (APE): each estimated pose against its reference, in the frames they are given in; align
/// first. Throws std::runtime_error without a match.
[[nodiscard]] PoseErrors absolute_errors(const std::vector<PoseMatch>& matches);

struct RelativeErrorOptions
{
    StepOptions steps;
    /// Metres are measured along the reference's path; else along the estimate's, as evo does
    /// unless told otherwise. The reference's are the same for all estimates.
    bool steps_of_reference = false;
};

/// RPE: the estimated motion of each step against the reference's. No alignment changes it.
/// Throws std::runtime_error when the path has no step that long.
[[nodiscard]] PoseErrors relative_errors(
    const std::vector<PoseMatch>& matches, const RelativeErrorOptions& options = {});

/// The `count` errors of the largest distance, the worst first.
[[nodiscard]] std::vector<PoseError> worst_errors(const PoseErrors& errors, std::size_t count);
}  // namespace rtob

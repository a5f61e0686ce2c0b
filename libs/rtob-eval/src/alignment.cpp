// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/alignment.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace rtob
{
namespace
{
struct Position
{
    double x = 0, y = 0;
};

Position mean_position(const std::vector<PoseMatch>& matches, Pose2 PoseMatch::*side)
{
    Position sum;
    for (const auto& match : matches)
    {
        sum.x += (match.*side).x;
        sum.y += (match.*side).y;
    }
    const auto n = static_cast<double>(matches.size());
    return {sum.x / n, sum.y / n};
}

/// Sums over the positions about their means: what decides the turn in the plane.
struct Moments
{
    double dot = 0, cross = 0;  // of estimate and reference
    double estimate_squares = 0, reference_squares = 0;
};

Moments moments_about(
    const std::vector<PoseMatch>& matches, const Position& estimate_mean,
    const Position& reference_mean)
{
    Moments sums;
    for (const auto& [i, j, time_s, estimate, reference] : matches)
    {
        const double ex = estimate.x - estimate_mean.x, ey = estimate.y - estimate_mean.y;
        const double rx = reference.x - reference_mean.x, ry = reference.y - reference_mean.y;
        sums.dot += ex * rx + ey * ry;
        sums.cross += ex * ry - ey * rx;
        sums.estimate_squares += ex * ex + ey * ey;
        sums.reference_squares += rx * rx + ry * ry;
    }
    return sums;
}

void check_turn_is_held(const Moments& sums, std::size_t count)
{
    constexpr double standing_m = 1e-6;  // files hold positions to the micrometre
    const double least_squares_m2 = static_cast<double>(count) * standing_m * standing_m;
    const std::string advice = " Align by the origin, or not at all";
    if (count == 1)
        throw std::runtime_error("alignment se2 finds no turn: only one pose is matched." + advice);
    if (sums.estimate_squares <= least_squares_m2 || sums.reference_squares <= least_squares_m2)
        throw std::runtime_error(
            "alignment se2 finds no turn: the " + std::to_string(count) + " matched poses of the " +
            (sums.estimate_squares <= least_squares_m2 ? "estimate" : "reference") +
            " are all in one place." + advice);
    // Mirrored paths, for instance: every turn is as good as any other.
    constexpr double least_agreement = 1e-9;
    if (std::hypot(sums.dot, sums.cross) <=
        least_agreement * std::sqrt(sums.estimate_squares * sums.reference_squares))
        throw std::runtime_error(
            "alignment se2 finds no turn: the paths have nothing in common." + advice);
}

Pose2 least_squares_motion(const std::vector<PoseMatch>& matches)
{
    const Position estimate = mean_position(matches, &PoseMatch::estimate);
    const Position reference = mean_position(matches, &PoseMatch::reference);
    const Moments sums = moments_about(matches, estimate, reference);
    check_turn_is_held(sums, matches.size());
    const double yaw = std::atan2(sums.cross, sums.dot);
    const double c = std::cos(yaw), s = std::sin(yaw);
    return {
        reference.x - c * estimate.x + s * estimate.y,
        reference.y - s * estimate.x - c * estimate.y, wrap_angle(yaw)};
}
}  // namespace

Pose2 alignment_of(const std::vector<PoseMatch>& matches, Alignment alignment)
{
    if (matches.empty()) throw std::runtime_error("there are no matched poses to align");
    switch (alignment)
    {
        case Alignment::None:
            return {};
        case Alignment::Origin:
            return compose(matches.front().reference, inverse(matches.front().estimate));
        case Alignment::Se2:
            return least_squares_motion(matches);
    }
    throw std::invalid_argument("unknown alignment");
}

std::vector<PoseMatch> moved_estimates(
    std::vector<PoseMatch> matches, const Pose2& pose_reference_estimate)
{
    for (auto& match : matches) match.estimate = compose(pose_reference_estimate, match.estimate);
    return matches;
}
}  // namespace rtob

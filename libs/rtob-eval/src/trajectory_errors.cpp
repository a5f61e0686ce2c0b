// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/trajectory_errors.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace rtob
{
namespace
{
constexpr double deg_per_rad = 180 / 3.14159265358979323846;

PoseError error_of(std::size_t match, const Pose2& residual)
{
    PoseError error;
    error.match = match;
    error.distance_m = std::hypot(residual.x, residual.y);
    error.turn_deg = std::abs(residual.yaw) * deg_per_rad;
    // |R - I|^2 = 2 (cos - 1)^2 + 2 sin^2 = 8 sin^2(yaw / 2), and no rounding where yaw is small
    error.full = std::hypot(error.distance_m, std::sqrt(8.0) * std::sin(residual.yaw / 2));
    return error;
}

ErrorStatistics statistics_of(const std::vector<PoseError>& errors, double PoseError::*figure)
{
    std::vector<double> values;
    values.reserve(errors.size());
    for (const auto& error : errors) values.push_back(error.*figure);
    return error_statistics(std::move(values));
}

PoseErrors with_statistics(std::vector<PoseError> errors)
{
    PoseErrors result;
    result.distance_m = statistics_of(errors, &PoseError::distance_m);
    result.turn_deg = statistics_of(errors, &PoseError::turn_deg);
    result.full = statistics_of(errors, &PoseError::full);
    result.errors = std::move(errors);
    return result;
}

std::vector<Pose2> path_of(const std::vector<PoseMatch>& matches, Pose2 PoseMatch::*side)
{
    std::vector<Pose2> path;
    path.reserve(matches.size());
    for (const auto& match : matches) path.push_back(match.*side);
    return path;
}

std::string delta_text(const StepOptions& options)
{
    char text[64];
    const char* const frames = options.delta == 1 ? "frame" : "frames";
    std::snprintf(
        text, sizeof text, "%g %s", options.delta,
        options.unit == DeltaUnit::Frames ? frames : "m");
    return text;
}
}  // namespace

PoseErrors absolute_errors(const std::vector<PoseMatch>& matches)
{
    if (matches.empty()) throw std::runtime_error("there are no matched poses to compare");
    std::vector<PoseError> errors;
    for (std::size_t i = 0; i < matches.size(); ++i)
        errors.push_back(error_of(i, between(matches[i].reference, matches[i].estimate)));
    return with_statistics(std::move(errors));
}

PoseErrors relative_errors(
    const std::vector<PoseMatch>& matches, const RelativeErrorOptions& options)
{
    const auto side = options.steps_of_reference ? &PoseMatch::reference : &PoseMatch::estimate;
    const auto steps = steps_along(path_of(matches, side), options.steps);
    if (steps.empty())
        throw std::runtime_error(
            "no two of the " + std::to_string(matches.size()) + " matched poses are " +
            delta_text(options.steps) + " apart along the path: take a smaller step");
    std::vector<PoseError> errors;
    for (const auto& [from, to] : steps)
    {
        const Pose2 reference = between(matches[from].reference, matches[to].reference);
        const Pose2 estimate = between(matches[from].estimate, matches[to].estimate);
        errors.push_back(error_of(to, between(reference, estimate)));
    }
    return with_statistics(std::move(errors));
}

std::vector<PoseError> worst_errors(const PoseErrors& errors, std::size_t count)
{
    auto worst = errors.errors;
    std::stable_sort(
        worst.begin(), worst.end(),
        [](const PoseError& a, const PoseError& b) { return a.distance_m > b.distance_m; });
    worst.resize(std::min(count, worst.size()));
    return worst;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/steps.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rtob
{
namespace
{
void validate(const StepOptions& options)
{
    if (!(options.delta > 0) || !std::isfinite(options.delta))
        throw std::invalid_argument("the step between compared poses must be above 0");
    if (options.unit == DeltaUnit::Frames && options.delta != std::floor(options.delta))
        throw std::invalid_argument("a step in frames must be a whole number");
    if (!(options.tolerance >= 0))
        throw std::invalid_argument("the tolerance of a step must be at least 0");
}

std::vector<Step> steps_by_frames(std::size_t count, const StepOptions& options)
{
    std::vector<Step> steps;
    if (options.delta >= static_cast<double>(count)) return steps;
    const auto delta = static_cast<std::size_t>(options.delta);
    const std::size_t stride = options.choice == StepChoice::All ? 1 : delta;
    for (std::size_t from = 0; from + delta < count; from += stride)
        steps.push_back({from, from + delta});
    return steps;
}

/// How far the vehicle has driven when it is at each pose.
std::vector<double> driven_m(const std::vector<Pose2>& path)
{
    std::vector<double> driven(path.size(), 0);
    for (std::size_t i = 1; i < path.size(); ++i)
        driven[i] =
            driven[i - 1] + std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
    return driven;
}

std::vector<Step> consecutive_steps_by_path(const std::vector<Pose2>& path, double delta_m)
{
    std::vector<Step> steps;
    double since_last_m = 0;  // from zero each time: a running total would round differently
    std::size_t last = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
        since_last_m += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
        if (since_last_m < delta_m) continue;
        steps.push_back({last, i});
        last = i;
        since_last_m = 0;
    }
    return steps;
}

std::vector<Step> all_steps_by_path(const std::vector<Pose2>& path, double delta_m, double tol_m)
{
    const auto driven = driven_m(path);
    std::vector<Step> steps;
    for (std::size_t from = 0; from + 1 < driven.size(); ++from)
    {
        const auto begin = driven.begin() + static_cast<std::ptrdiff_t>(from) + 1;
        const double target_m = driven[from] + delta_m;
        const auto off_m = [&](auto at) { return std::abs(*at - driven[from] - delta_m); };
        auto best = std::lower_bound(begin, driven.end(), target_m);
        if (best != begin)
        {
            // The first of the poses where the vehicle stood before the target.
            const auto before = std::lower_bound(begin, best, *(best - 1));
            if (best == driven.end() || off_m(before) <= off_m(best)) best = before;
        }
        if (off_m(best) <= tol_m)
            steps.push_back({from, static_cast<std::size_t>(best - driven.begin())});
    }
    return steps;
}
}  // namespace

std::vector<Step> steps_along(const std::vector<Pose2>& path, const StepOptions& options)
{
    validate(options);
    if (options.unit == DeltaUnit::Frames) return steps_by_frames(path.size(), options);
    if (options.choice == StepChoice::Consecutive)
        return consecutive_steps_by_path(path, options.delta);
    return all_steps_by_path(path, options.delta, options.tolerance * options.delta);
}
}  // namespace rtob

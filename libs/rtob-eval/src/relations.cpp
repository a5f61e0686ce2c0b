// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/relations.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "stamp_index.h"

namespace rtob
{
namespace
{
constexpr double max_stamp_difference_s = 1e-4;
constexpr double deg_per_rad = 180 / 3.14159265358979323846;

/// The pose with the stamp nearest to `time_s`; none when that is not near enough.
std::optional<std::size_t> pose_at(const StampIndex& stamps, double time_s)
{
    if (stamps.size() == 0) return std::nullopt;
    const auto place = stamps.nearestPlace(time_s);
    if (std::abs(stamps.stampAt(place) - time_s) > max_stamp_difference_s) return std::nullopt;
    return stamps.pose(place);
}

const Pose2& checked(const StampedPose2& stamped)
{
    const Pose2& pose = stamped.pose;
    if (!is_finite(pose))
        throw std::runtime_error(
            "the trajectory's pose at " + stamp_text(stamped.time_s) + " is not finite");
    return pose;
}

template <class Value>
MeanStd mean_std(const std::vector<RelationResidual>& residuals, Value&& value)
{
    const auto n = static_cast<double>(residuals.size());
    double sum = 0;
    for (const auto& residual : residuals) sum += value(residual);
    const double mean = sum / n;
    double squares = 0;
    for (const auto& residual : residuals) squares += std::pow(value(residual) - mean, 2);
    return {mean, std::sqrt(squares / n)};
}
}  // namespace

RelationErrors relation_errors(
    const std::vector<StampedPose2>& trajectory, const std::vector<Relation>& relations)
{
    for (const auto& stamped : trajectory)
        if (!std::isfinite(stamped.time_s))
            throw std::runtime_error("a stamp of the trajectory is not finite");
    const StampIndex stamps(trajectory);
    RelationErrors errors;
    for (std::size_t i = 0; i < relations.size(); ++i)
    {
        const auto first = pose_at(stamps, relations[i].t1_s);
        const auto second = pose_at(stamps, relations[i].t2_s);
        if (!first || !second)
        {
            ++errors.unmatched_relations;
            continue;
        }
        const Pose2 estimate_1_2 =
            between(checked(trajectory[*first]), checked(trajectory[*second]));
        const Pose2 residual = between(relations[i].pose_1_2, estimate_1_2);
        errors.residuals.push_back(
            {i, std::hypot(residual.x, residual.y), std::abs(residual.yaw) * deg_per_rad, *first,
             *second});
    }
    auto& residuals = errors.residuals;
    if (residuals.empty())
        throw std::runtime_error(
            "none of the " + std::to_string(relations.size()) +
            " relations names the stamps of two poses; the trajectory has " + stamps.range() +
            (relations.empty()
                 ? ""
                 : ", the first relation starts at " + stamp_text(relations[0].t1_s)) +
            ". Take the relations of the log that the trajectory was made of");
    const auto squared = [](double v) { return v * v; };
    errors.distance_m = mean_std(residuals, [](const auto& r) { return r.distance_m; });
    errors.turn_deg = mean_std(residuals, [](const auto& r) { return r.turn_deg; });
    errors.squared_distance_m2 =
        mean_std(residuals, [&](const auto& r) { return squared(r.distance_m); });
    errors.squared_turn_deg2 =
        mean_std(residuals, [&](const auto& r) { return squared(r.turn_deg); });
    return errors;
}

std::vector<RelationResidual> worst_residuals(const RelationErrors& errors, std::size_t count)
{
    auto worst = errors.residuals;
    std::stable_sort(
        worst.begin(), worst.end(),
        [](const auto& a, const auto& b) { return a.distance_m > b.distance_m; });
    worst.resize(std::min(count, worst.size()));
    return worst;
}
}  // namespace rtob

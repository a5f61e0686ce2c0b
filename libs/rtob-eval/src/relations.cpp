// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/relations.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace rtob
{
namespace
{
constexpr double max_stamp_difference_s = 1e-4;
constexpr double deg_per_rad = 180 / 3.14159265358979323846;

std::string stamp_text(double time_s)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.6f s", time_s);
    return text;
}

/// Poses by their stamps.
class PosesByTime
{
 public:
    explicit PosesByTime(std::vector<StampedPose2> trajectory) : poses_(std::move(trajectory))
    {
        for (const auto& stamped : poses_)
            if (!std::isfinite(stamped.time_s))
                throw std::runtime_error("a stamp of the trajectory is not finite");
        // Stable: of equal stamps the first of the log stays the first.
        std::stable_sort(poses_.begin(), poses_.end(), isEarlier);
    }

    /// Null when no stamp is near enough.
    const StampedPose2* nearest(double time_s) const
    {
        const StampedPose2 wanted{time_s, {}};
        const auto after = std::lower_bound(poses_.begin(), poses_.end(), wanted, isEarlier);
        const StampedPose2* best = nullptr;
        if (after != poses_.end()) best = &*after;
        if (after != poses_.begin())
        {
            // The first one of those that share the last stamp before.
            const auto before = std::lower_bound(poses_.begin(), after, *(after - 1), isEarlier);
            if (!best || time_s - before->time_s < best->time_s - time_s) best = &*before;
        }
        if (!best || std::abs(best->time_s - time_s) > max_stamp_difference_s) return nullptr;
        return best;
    }

    std::string range() const
    {
        if (poses_.empty()) return "the trajectory is empty";
        return "the trajectory spans " + stamp_text(poses_.front().time_s) + " to " +
               stamp_text(poses_.back().time_s);
    }

 private:
    static bool isEarlier(const StampedPose2& a, const StampedPose2& b)
    {
        return a.time_s < b.time_s;
    }

    std::vector<StampedPose2> poses_;
};

const Pose2& checked(const StampedPose2& stamped)
{
    const Pose2& pose = stamped.pose;
    if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.yaw))
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
    const PosesByTime poses(trajectory);
    RelationErrors errors;
    for (std::size_t i = 0; i < relations.size(); ++i)
    {
        const auto* const first = poses.nearest(relations[i].t1_s);
        const auto* const second = poses.nearest(relations[i].t2_s);
        if (!first || !second)
        {
            ++errors.unmatched_relations;
            continue;
        }
        const Pose2 estimate_1_2 = between(checked(*first), checked(*second));
        const Pose2 residual = between(relations[i].pose_1_2, estimate_1_2);
        errors.residuals.push_back(
            {i, std::hypot(residual.x, residual.y), std::abs(residual.yaw) * deg_per_rad});
    }
    auto& residuals = errors.residuals;
    if (residuals.empty())
        throw std::runtime_error(
            "none of the " + std::to_string(relations.size()) +
            " relations names the stamps of two poses; " + poses.range() +
            (relations.empty() ? "" : ", the first relation " + stamp_text(relations[0].t1_s)));
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

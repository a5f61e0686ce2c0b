// SPDX-License-Identifier: BSD-3-Clause
#include "compare/truth.h"

#include <rtob/eval/trajectory_score.h>
#include <rtob/io/pose_file.h>

#include <algorithm>
#include <stdexcept>

namespace rtob
{
namespace
{
void sort_by_time(std::vector<ErrorAt>& errors)
{
    std::stable_sort(
        errors.begin(), errors.end(),
        [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
}

Accuracy accuracy_by_relations(
    const std::vector<StampedPose2>& trajectory, const std::vector<Relation>& relations)
{
    const auto errors = relation_errors(trajectory, relations);
    Accuracy accuracy;
    accuracy.distance_m = errors.distance_m;
    accuracy.turn_deg = errors.turn_deg;
    for (const auto& residual : errors.residuals)
    {
        const auto& relation = relations[residual.relation];
        accuracy.errors.push_back({std::max(relation.t1_s, relation.t2_s), residual.distance_m});
    }
    sort_by_time(accuracy.errors);
    return accuracy;
}
Accuracy accuracy_by_poses(
    const std::vector<StampedPose2>& trajectory, const std::vector<StampedPose2>& truth)
{
    const auto score = score_trajectory(trajectory, truth);
    const auto& absolute = score.absolute;
    Accuracy accuracy;
    accuracy.distance_m = {absolute.distance_m.mean, absolute.distance_m.std};
    accuracy.turn_deg = {absolute.turn_deg.mean, absolute.turn_deg.std};
    for (const auto& error : absolute.errors)
        accuracy.errors.push_back({score.matches[error.match].time_s, error.distance_m});
    sort_by_time(accuracy.errors);
    return accuracy;
}

TruthKind kind_of(const std::string& file)
{
    return pose_file_kind(file) == PoseFileKind::Relations ? TruthKind::Relations
                                                           : TruthKind::Trajectory;
}

/// Calls, and names the file in what that throws.
template <class Call>
void naming(const std::string& file, Call&& call)
{
    try
    {
        call();
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error("truth file " + file + ": " + error.what());
    }
}
}  // namespace

Truth::Truth(const std::string& file) : file_(file), kind_(kind_of(file))
{
    if (kind_ == TruthKind::Relations)
        relations_ = read_relations(file);
    else
        poses_ = read_poses(file);
}

void Truth::checkTimes(const std::vector<StampedPose2>& scans) const
{
    naming(
        file_,
        [&]
        {
            if (kind_ == TruthKind::Relations)
                static_cast<void>(relation_errors(scans, relations_));
            if (kind_ == TruthKind::Trajectory) static_cast<void>(match_by_time(scans, poses_));
        });
}

std::optional<Accuracy> Truth::judge(const std::vector<StampedPose2>& trajectory) const
{
    std::optional<Accuracy> accuracy;
    naming(
        file_,
        [&]
        {
            if (kind_ == TruthKind::Relations)
                accuracy = accuracy_by_relations(trajectory, relations_);
            if (kind_ == TruthKind::Trajectory) accuracy = accuracy_by_poses(trajectory, poses_);
        });
    return accuracy;
}
}  // namespace rtob

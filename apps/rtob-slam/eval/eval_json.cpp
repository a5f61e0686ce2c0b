// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/enum_names.h>

#include <nlohmann/json.hpp>

#include "eval/eval_report.h"

namespace rtob
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr std::size_t worst_shown = 5;
constexpr double deg_per_rad = 180 / 3.14159265358979323846;

Json mean_std_json(const MeanStd& figure)
{
    return {{"mean", figure.mean}, {"std", figure.std}};
}

Json json_of(const RelationEvaluation& evaluation)
{
    const auto& errors = evaluation.errors;
    Json worst = Json::array();
    for (const auto& residual : worst_residuals(errors, worst_shown))
    {
        const auto& relation = evaluation.relations[residual.relation];
        worst.push_back(
            {{"t1_s", relation.t1_s},
             {"t2_s", relation.t2_s},
             {"translation_m", residual.distance_m},
             {"rotation_deg", residual.turn_deg}});
    }
    return {
        {"reference", "relations"},
        {"relations_used", errors.residuals.size()},
        {"relations_without_pose", errors.unmatched_relations},
        {"translation_m", mean_std_json(errors.distance_m)},
        {"squared_translation_m2", mean_std_json(errors.squared_distance_m2)},
        {"rotation_deg", mean_std_json(errors.turn_deg)},
        {"squared_rotation_deg2", mean_std_json(errors.squared_turn_deg2)},
        {"worst", worst}};
}

Json statistics_json(const ErrorStatistics& s)
{
    return {{"rmse", s.rmse}, {"mean", s.mean}, {"median", s.median}, {"std", s.std},
            {"min", s.min},   {"max", s.max},   {"sse", s.sse}};
}

void add_statistics(Json& json, const PoseErrors& errors)
{
    json["translation_m"] = statistics_json(errors.distance_m);
    json["rotation_deg"] = statistics_json(errors.turn_deg);
    json["full"] = statistics_json(errors.full);
}

Json relative_json(const RelativeErrorOptions& options, const PoseErrors& errors)
{
    const auto& steps = options.steps;
    Json json{
        {"delta", steps.delta},
        {"unit", name_of(steps.unit)},
        {"steps", name_of(steps.choice)},
        {"path", options.steps_of_reference ? "reference" : "estimate"},
        {"count", errors.errors.size()}};
    add_statistics(json, errors);
    return json;
}

Json json_of(const TrajectoryEvaluation& evaluation)
{
    const auto& score = evaluation.score;
    const Pose2& motion = score.pose_reference_estimate;
    Json ate, rpe = Json::array(), worst = Json::array();
    add_statistics(ate, score.absolute);
    for (std::size_t i = 0; i < score.relative.size(); ++i)
        rpe.push_back(relative_json(evaluation.options.relative[i], score.relative[i]));
    for (const auto& error : worst_errors(score.absolute, worst_shown))
        worst.push_back(
            {{"time_s", score.matches[error.match].time_s},
             {"translation_m", error.distance_m},
             {"rotation_deg", error.turn_deg}});
    return {
        {"reference", "trajectory"},
        {"estimate_poses", score.estimate_poses},
        {"reference_poses", score.reference_poses},
        {"matched_poses", score.matches.size()},
        {"max_difference_s", evaluation.options.max_difference_s},
        {"alignment",
         {{"kind", name_of(evaluation.options.alignment)},
          {"x_m", motion.x},
          {"y_m", motion.y},
          {"yaw_deg", motion.yaw * deg_per_rad}}},
        {"ate", ate},
        {"rpe", rpe},
        {"worst", worst}};
}

Json json_of(const MapEvaluation& evaluation)
{
    const auto& agreement = evaluation.agreement;
    const Pose2& motion = agreement.pose_reference_estimate;
    return {
        {"reference", "map"},
        {"cell_m", evaluation.options.cell_m},
        {"tolerance_m", evaluation.options.tolerance_m},
        {"estimate_cells", agreement.estimate_cells},
        {"reference_cells", agreement.reference_cells},
        {"alignment",
         {{"x_m", motion.x}, {"y_m", motion.y}, {"yaw_deg", motion.yaw * deg_per_rad}}},
        {"estimate_share", agreement.estimate_share},
        {"reference_share", agreement.reference_share},
        {"mean_distance_m", agreement.mean_distance_m}};
}
}  // namespace

std::string report_json(const Evaluation& evaluation)
{
    return std::visit([](const auto& each) { return json_of(each); }, evaluation).dump(2) + "\n";
}
}  // namespace rtob

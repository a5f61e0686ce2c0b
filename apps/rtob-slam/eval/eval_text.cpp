// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/enum_names.h>

#include <cstdarg>
#include <cstdio>

#include "eval/eval_report.h"

namespace rtob
{
namespace
{
constexpr std::size_t worst_shown = 5;
constexpr double deg_per_rad = 180 / 3.14159265358979323846;

/// As printf; one line, at most 400 bytes.
[[gnu::format(printf, 1, 2)]] std::string line(const char* format, ...)
{
    char text[400];
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

std::string mean_std_line(const char* name, const MeanStd& figure, const char* unit)
{
    return line("%-20s %10.4f +- %.4f %s\n", name, figure.mean, figure.std, unit);
}

std::string text_of(const RelationEvaluation& evaluation)
{
    const auto& errors = evaluation.errors;
    std::string text = line("%zu relations used", errors.residuals.size());
    if (errors.unmatched_relations > 0)
        text += line(", %zu name a time without a pose", errors.unmatched_relations);
    text += "; mean +- standard deviation\n";
    text += mean_std_line("translation", errors.distance_m, "m");
    text += mean_std_line("translation squared", errors.squared_distance_m2, "m^2");
    text += mean_std_line("rotation", errors.turn_deg, "deg");
    text += mean_std_line("rotation squared", errors.squared_turn_deg2, "deg^2");
    text += "worst:\n";
    for (const auto& residual : worst_residuals(errors, worst_shown))
    {
        const auto& relation = evaluation.relations[residual.relation];
        text += line(
            "  %8.3f m %8.3f deg  from %.6f to %.6f\n", residual.distance_m, residual.turn_deg,
            relation.t1_s, relation.t2_s);
    }
    return text;
}

std::string statistics_line(const char* name, const ErrorStatistics& s)
{
    return line(
        "  %-16s %10.4f %10.4f %10.4f %10.4f %10.4f %10.4f %12.4f\n", name, s.rmse, s.mean,
        s.median, s.std, s.min, s.max, s.sse);
}

std::string error_lines(const PoseErrors& errors)
{
    return statistics_line("translation, m", errors.distance_m) +
           statistics_line("rotation, deg", errors.turn_deg) +
           statistics_line("full, no unit", errors.full);
}

std::string alignment_line(const TrajectoryEvaluation& evaluation)
{
    const Pose2& motion = evaluation.score.pose_reference_estimate;
    if (evaluation.options.alignment == Alignment::None) return "aligned  none\n";
    return line(
        "aligned  %s: estimate turned by %.3f deg, then shifted by x %.3f m, y %.3f m\n",
        std::string(name_of(evaluation.options.alignment)).c_str(), motion.yaw * deg_per_rad,
        motion.x, motion.y);
}

std::string text_of(const TrajectoryEvaluation& evaluation)
{
    const auto& score = evaluation.score;
    std::string text = line(
        "matched  %zu of %zu estimated poses with %zu of %zu of the reference, stamps within %g s"
        "\n",
        score.matches.size(), score.estimate_poses, score.matches.size(), score.reference_poses,
        evaluation.options.max_difference_s);
    text += alignment_line(evaluation);
    text += line(
        "  %-16s %10s %10s %10s %10s %10s %10s %12s\n", "", "rmse", "mean", "median", "std", "min",
        "max", "sse");
    text += "ATE (absolute)\n" + error_lines(score.absolute);
    for (std::size_t i = 0; i < score.relative.size(); ++i)
        text += line(
                    "RPE (relative) over %s: %zu of them\n",
                    step_text(evaluation.options.relative[i]).c_str(),
                    score.relative[i].errors.size()) +
                error_lines(score.relative[i]);
    text += "worst ATE:\n";
    for (const auto& error : worst_errors(score.absolute, worst_shown))
        text += line(
            "  %8.3f m %8.3f deg  at %.6f\n", error.distance_m, error.turn_deg,
            score.matches[error.match].time_s);
    return text;
}

std::string text_of(const MapEvaluation& evaluation)
{
    constexpr double percent = 100;
    const auto& agreement = evaluation.agreement;
    const Pose2& motion = agreement.pose_reference_estimate;
    return line(
               "laid on  estimate turned by %.3f deg, then shifted by x %.3f m, y %.3f m\n",
               motion.yaw * deg_per_rad, motion.x, motion.y) +
           line(
               "shared   %.1f %% of the estimate's %zu cells of %g m, %.1f %% of the reference's "
               "%zu, lie within %g m of one of the other\n",
               percent * agreement.estimate_share, agreement.estimate_cells,
               evaluation.options.cell_m, percent * agreement.reference_share,
               agreement.reference_cells, evaluation.options.tolerance_m) +
           line("distance %.4f m on average, of these cells\n", agreement.mean_distance_m);
}
}  // namespace

std::string step_text(const RelativeErrorOptions& options)
{
    const auto& steps = options.steps;
    const char* const kind = steps.choice == StepChoice::All ? "all" : "consecutive";
    if (steps.unit == DeltaUnit::Frames)
        return line("%s steps of %g frame%s", kind, steps.delta, steps.delta == 1 ? "" : "s");
    return line(
        "%s steps of %g m along the %s", kind, steps.delta,
        options.steps_of_reference ? "reference" : "estimate");
}

std::string report_text(const Evaluation& evaluation)
{
    return std::visit([](const auto& each) { return text_of(each); }, evaluation);
}
}  // namespace rtob

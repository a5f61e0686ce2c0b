// SPDX-License-Identifier: BSD-3-Clause
#include "eval/eval_files.h"

#include <rtob/core/enum_names.h>
#include <rtob/eval/error_pictures.h>
#include <rtob/eval/map_overlay.h>
#include <rtob/io/atomic_file.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "eval/eval_report.h"

namespace rtob
{
namespace
{
struct Pictures
{
    ErrorPlotInput plot;
    ErrorPathInput path;
};

std::string metres_fact(const char* name, double mean_m, double largest_m)
{
    char text[160];
    std::snprintf(text, sizeof text, "%s: mean %.4g m, largest %.4g m", name, mean_m, largest_m);
    return text;
}

Pictures pictures_of(const TrajectoryEvaluation& evaluation)
{
    const auto& score = evaluation.score;
    const auto& absolute = score.absolute;
    Pictures pictures;
    ErrorCurve distance{
        "translation error (ATE), m", {}, absolute.distance_m.mean, absolute.distance_m.rmse};
    ErrorCurve turn{
        "rotation error (ATE), deg", {}, absolute.turn_deg.mean, absolute.turn_deg.rmse};
    for (std::size_t i = 0; i < score.matches.size(); ++i)
    {
        const auto& error = absolute.errors[i];
        pictures.plot.times_s.push_back(score.matches[i].time_s);
        distance.values.push_back(error.distance_m);
        turn.values.push_back(error.turn_deg);
        pictures.path.path.push_back(score.matches[i].estimate);
        pictures.path.errors_m.push_back(error.distance_m);
    }
    pictures.plot.curves = {distance, turn};
    for (const auto& stamped : evaluation.reference)
        pictures.path.reference.push_back(stamped.pose);
    pictures.plot.facts =
        std::to_string(score.matches.size()) + " matched poses,  alignment " +
        std::string(name_of(evaluation.options.alignment)) + ",  " +
        metres_fact("translation error", absolute.distance_m.mean, absolute.distance_m.max);
    return pictures;
}

/// A relation belongs to two poses: each pose shows the largest error of its relations, and the
/// plot the errors at the later pose's time.
Pictures pictures_of(const RelationEvaluation& evaluation)
{
    const auto& errors = evaluation.errors;
    const auto rmse = [](const MeanStd& squared) { return std::sqrt(squared.mean); };
    Pictures pictures;
    ErrorCurve distance{
        "translation error of each relation, m",
        {},
        errors.distance_m.mean,
        rmse(errors.squared_distance_m2)};
    ErrorCurve turn{
        "rotation error of each relation, deg",
        {},
        errors.turn_deg.mean,
        rmse(errors.squared_turn_deg2)};
    auto& path = pictures.path;
    for (const auto& stamped : evaluation.estimate) path.path.push_back(stamped.pose);
    path.errors_m.assign(path.path.size(), std::numeric_limits<double>::quiet_NaN());
    double largest_m = 0;
    for (const auto& residual : errors.residuals)
    {
        pictures.plot.times_s.push_back(evaluation.estimate[residual.pose_2].time_s);
        distance.values.push_back(residual.distance_m);
        turn.values.push_back(residual.turn_deg);
        for (const auto pose : {residual.pose_1, residual.pose_2})
            path.errors_m[pose] = std::fmax(path.errors_m[pose], residual.distance_m);
        largest_m = std::max(largest_m, residual.distance_m);
    }
    pictures.plot.curves = {distance, turn};
    pictures.plot.facts = std::to_string(errors.residuals.size()) + " relations,  " +
                          metres_fact("translation error", errors.distance_m.mean, largest_m);
    return pictures;
}

void write_path_pictures(const std::string& folder, Pictures pictures, const std::string& title)
{
    pictures.plot.title = "Error over time: " + title;
    pictures.path.title = "Path coloured by error: " + title;
    pictures.path.facts = pictures.plot.facts;
    write_error_plot(folder + "/eval_errors.png", pictures.plot);
    write_error_path(folder + "/eval_path.png", pictures.path);
}

void write_pictures(
    const std::string& folder, const MapEvaluation& evaluation, const std::string& title)
{
    constexpr double percent = 100;
    const auto& agreement = evaluation.agreement;
    char facts[160];
    std::snprintf(
        facts, sizeof facts,
        "red: estimate, blue: reference;  %.0f %% and %.0f %% of their cells lie within %.2f m",
        percent * agreement.estimate_share, percent * agreement.reference_share,
        evaluation.options.tolerance_m);
    MapOverlayInput overlay;
    overlay.points_reference = evaluation.points_reference.view();
    overlay.points_estimate = evaluation.points_estimate.view();
    overlay.title = "Maps laid on each other: " + title;
    overlay.facts = facts;
    write_map_overlay(folder + "/eval_maps.png", overlay);
}

template <class OfPaths>
void write_pictures(const std::string& folder, const OfPaths& evaluation, const std::string& title)
{
    write_path_pictures(folder, pictures_of(evaluation), title);
}
}  // namespace

void write_eval_files(
    const std::string& folder, const Evaluation& evaluation, const std::string& title)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw std::runtime_error(
            "folder " + folder + " cannot be made: " + error.message() + ". Name another one.");
    write_text(folder + "/eval.txt", report_text(evaluation));
    write_text(folder + "/eval.json", report_json(evaluation));
    std::visit([&](const auto& each) { write_pictures(folder, each, title); }, evaluation);
}
}  // namespace rtob

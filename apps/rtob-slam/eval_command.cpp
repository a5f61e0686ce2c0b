// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/relations.h>
#include <rtob/io/tum.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "exit_code.h"
#include "verbs.h"

namespace rtob
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr std::size_t worst_shown = 5;

struct EvalFlags
{
    std::string trajectory, relations;
    bool json = false;
};

struct Evaluation
{
    std::vector<Relation> relations;
    RelationErrors errors;
};

Json mean_std_json(const MeanStd& figure)
{
    return {{"mean", figure.mean}, {"std", figure.std}};
}

Json worst_json(const Evaluation& evaluation)
{
    Json worst = Json::array();
    for (const auto& residual : worst_residuals(evaluation.errors, worst_shown))
    {
        const auto& relation = evaluation.relations[residual.relation];
        worst.push_back(
            {{"t1_s", relation.t1_s},
             {"t2_s", relation.t2_s},
             {"translation_m", residual.distance_m},
             {"rotation_deg", residual.turn_deg}});
    }
    return worst;
}

void print_json(const Evaluation& evaluation)
{
    const auto& errors = evaluation.errors;
    const Json json{
        {"relations_used", errors.residuals.size()},
        {"relations_without_pose", errors.unmatched_relations},
        {"translation_m", mean_std_json(errors.distance_m)},
        {"squared_translation_m2", mean_std_json(errors.squared_distance_m2)},
        {"rotation_deg", mean_std_json(errors.turn_deg)},
        {"squared_rotation_deg2", mean_std_json(errors.squared_turn_deg2)},
        {"worst", worst_json(evaluation)}};
    std::cout << json.dump(2) << "\n";
}

void print_figure(const char* name, const MeanStd& figure, const char* unit)
{
    std::printf("%-20s %10.4f +- %.4f %s\n", name, figure.mean, figure.std, unit);
}

void print_text(const Evaluation& evaluation)
{
    const auto& errors = evaluation.errors;
    std::printf("%zu relations used", errors.residuals.size());
    if (errors.unmatched_relations > 0)
        std::printf(", %zu name a time without a pose", errors.unmatched_relations);
    std::printf("; mean +- standard deviation\n");
    print_figure("translation", errors.distance_m, "m");
    print_figure("translation squared", errors.squared_distance_m2, "m^2");
    print_figure("rotation", errors.turn_deg, "deg");
    print_figure("rotation squared", errors.squared_turn_deg2, "deg^2");
    std::printf("worst:\n");
    for (const auto& residual : worst_residuals(errors, worst_shown))
    {
        const auto& relation = evaluation.relations[residual.relation];
        std::printf(
            "  %8.3f m %8.3f deg  from %.6f to %.6f\n", residual.distance_m, residual.turn_deg,
            relation.t1_s, relation.t2_s);
    }
}

int eval(const EvalFlags& flags)
{
    Evaluation evaluation;
    const auto trajectory = read_tum(flags.trajectory);
    evaluation.relations = read_relations(flags.relations);
    evaluation.errors = relation_errors(trajectory, evaluation.relations);
    if (flags.json)
        print_json(evaluation);
    else
        print_text(evaluation);
    return kExitOk;
}
}  // namespace

VerbAction declare_eval(CLI::App& command)
{
    const auto flags = std::make_shared<EvalFlags>();
    command.add_option("TRAJECTORY", flags->trajectory, "a trajectory.tum of a run")
        ->type_name("")
        ->required();
    command
        .add_option("RELATIONS", flags->relations, "lines t1 t2 x y z roll pitch yaw; may be .gz")
        ->type_name("")
        ->required();
    command.add_flag("--json", flags->json, "print JSON");
    return [flags] { return eval(*flags); };
}
}  // namespace rtob

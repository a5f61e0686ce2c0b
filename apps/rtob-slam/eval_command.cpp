// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/pose_file.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "eval/eval_files.h"
#include "eval/eval_flags.h"
#include "eval/eval_report.h"
#include "eval/map_file.h"
#include "exit_code.h"
#include "usage_error.h"
#include "verbs.h"

namespace rtob
{
namespace
{
constexpr const char* footer =
    "EST is a trajectory.tum of a run. REF is a trajectory of the same log - a TUM file, lines\n"
    "`time_s x y yaw`, or a rawlog with poses - or hand-checked relations, lines\n"
    "`t1 t2 x y z roll pitch yaw`. All may be packed by gzip or bzip2; the content decides.\n"
    "Against a trajectory: ATE and RPE as evo defines them. Against relations: mean and standard\n"
    "deviation of their errors (Kuemmerle et al. 2009); the flags above are not for them.\n"
    "EST and REF may also be two maps (map.ply): how much of each lies on the other.\n"
    "docs/metrics.md says what each figure means.";

bool are_maps(const EvalFlags& flags)
{
    const bool is_map = is_ply_file(flags.estimate);
    if (is_map != is_ply_file(flags.reference))
        throw UsageError(
            (is_map ? flags.estimate : flags.reference) +
            " is a map and the other file is not: compare a map with a map");
    return is_map;
}

void refuse_flags_of_trajectories(const EvalFlags& flags, bool maps)
{
    const auto flag = flags.trajectoryFlag();
    if (flag.empty()) return;
    if (maps) throw UsageError(flag + ": maps do not need it");
    if (pose_file_kind(flags.reference) == PoseFileKind::Relations)
        throw UsageError(flag + ": " + flags.reference + " holds relations, which do not need it");
}

/// Two runs' files have the same name: their folders tell them apart.
std::string title_of(const EvalFlags& flags)
{
    const std::filesystem::path estimate(flags.estimate), reference(flags.reference);
    if (estimate.filename() != reference.filename())
        return estimate.filename().string() + " against " + reference.filename().string();
    const auto with_folder = [](const std::filesystem::path& file)
    { return (file.parent_path().filename() / file.filename()).string(); };
    return with_folder(estimate) + " against " + with_folder(reference);
}

int eval(const EvalFlags& flags)
{
    const auto options = score_options(flags);
    const bool maps = are_maps(flags);
    refuse_flags_of_trajectories(flags, maps);
    const Evaluation evaluation = maps ? evaluate_maps(flags.estimate, flags.reference)
                                       : evaluate(flags.estimate, flags.reference, options);
    if (!flags.folder.empty()) write_eval_files(flags.folder, evaluation, title_of(flags));
    std::cout << (flags.json ? report_json(evaluation) : report_text(evaluation));
    return kExitOk;
}
}  // namespace

VerbAction declare_eval(CLI::App& command)
{
    const auto flags = std::make_shared<EvalFlags>();
    command.add_option("EST", flags->estimate, "the trajectory to score, or a map")
        ->type_name("")
        ->required();
    command.add_option("REF", flags->reference, "the truth: a trajectory or relations; or a map")
        ->type_name("")
        ->required();
    const auto add = [&](const char* names, auto& value, const char* what, const char* meaning)
    { return command.add_option(names, value, meaning)->type_name(what); };
    add("-o,--output", flags->folder, "FOLDER", "write eval.txt, eval.json and pictures");
    command.add_flag("--json", flags->json, "print JSON");
    add("--align", flags->align, "HOW", "none, origin or se2 (least squares); default se2");
    add("--max-diff", flags->max_difference, "S", "between stamps that match; default 0.01");
    add("--delta", flags->deltas, "N|Nm",
        "steps of the RPE, in frames or metres (5, 2.5m); may be given again; default 1")
        ->allow_extra_args(false);
    command.add_flag(
        "--all-steps", flags->all_steps, "steps from every pose, not one after the other");
    command.add_flag(
        "--steps-of-reference", flags->steps_of_reference,
        "measure metres along REF, not along EST");
    add("--delta-tolerance", flags->tolerance, "SHARE",
        "of a step in metres, with --all-steps; default 0.1");
    command.footer(footer);
    return [flags] { return eval(*flags); };
}
}  // namespace rtob

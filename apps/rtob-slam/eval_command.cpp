// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/pose_file.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "eval/eval_files.h"
#include "eval/eval_flags.h"
#include "eval/eval_report.h"
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
    "docs/metrics.md says what each figure means.";

void refuse_flags_of_trajectories(const EvalFlags& flags)
{
    const auto flag = flags.trajectoryFlag();
    if (!flag.empty() && pose_file_kind(flags.reference) == PoseFileKind::Relations)
        throw UsageError(flag + ": " + flags.reference + " holds relations, which do not need it");
}

int eval(const EvalFlags& flags)
{
    const auto options = score_options(flags);
    refuse_flags_of_trajectories(flags);
    const auto evaluation = evaluate(flags.estimate, flags.reference, options);
    if (!flags.folder.empty())
        write_eval_files(
            flags.folder, evaluation,
            std::filesystem::path(flags.estimate).filename().string() + " against " +
                std::filesystem::path(flags.reference).filename().string());
    std::cout << (flags.json ? report_json(evaluation) : report_text(evaluation));
    return kExitOk;
}
}  // namespace

VerbAction declare_eval(CLI::App& command)
{
    const auto flags = std::make_shared<EvalFlags>();
    command.add_option("EST", flags->estimate, "the trajectory to score")
        ->type_name("")
        ->required();
    command.add_option("REF", flags->reference, "the truth: a trajectory or relations")
        ->type_name("")
        ->required();
    const auto add = [&](const char* names, auto& value, const char* what, const char* meaning)
    { return command.add_option(names, value, meaning)->type_name(what); };
    add("-o,--output", flags->folder, "FOLDER",
        "write eval.txt, eval.json, eval_errors.png and eval_path.png");
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

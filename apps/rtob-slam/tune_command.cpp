// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "exit_code.h"
#include "tune/tune_job.h"
#include "usage_error.h"
#include "verbs.h"

namespace rtob
{
namespace
{
struct TuneFlags
{
    TuneJob job;
    std::string config_file;
    std::vector<std::string> sets;
    bool no_odometry = false, quiet = false;
};

constexpr const char* footer =
    "LOG|WORLD is a log (then --truth is needed) or a world of `rtob-slam simulate` (*.yaml), "
    "which\n"
    "is flown once a seed. Drawn points, iterations, correspondence distance, the density and its\n"
    "constants are changed one at a time; accuracy is measured on all cores, time with nothing\n"
    "beside. Chosen is what is most accurate, and of points and iterations the most that keep 99 "
    "%\n"
    "of the scans within the budget: see docs/tuning.md.\n"
    "The folder gets tune.ini (the suggestion), tune.md (all figures) and a plot for each option.\n"
    "Exit codes: 0 ok; 1 failed; 2 wrong usage.";

int tune_with(TuneFlags flags)
{
    auto& job = flags.job;
    auto options = parse_set_flags(flags.sets);
    if (flags.no_odometry) options.push_back({"--no-odometry", "Run", "use_odometry", "false"});
    job.config = load_run_config(flags.config_file, options);
    if (job.folder.empty())
        job.folder = "out/tune-" + std::filesystem::path(job.source).stem().string();
    const bool shows = !flags.quiet && isatty(STDERR_FILENO) != 0;
    const auto result = tune(
        job,
        [&](const std::string& doing)
        {
            if (shows) std::cerr << "\r\033[K" << doing << std::flush;
        });
    if (shows) std::cerr << "\r\033[K";
    if (!flags.quiet)
        std::cout << tuning_text(job, result) << "\nResults in " << job.folder << "\n";
    if (is_feasible(result.after, job.budget_ms)) return kExitOk;
    std::cerr << "rtob-slam: no setting that was tried keeps the budget and loses no scan\n";
    return kExitFailed;
}
}  // namespace

VerbAction declare_tune(CLI::App& command)
{
    const auto flags = std::make_shared<TuneFlags>();
    auto& job = flags->job;
    command.add_option("LOG|WORLD", job.source, "what to tune on")->type_name("")->required();
    const auto add = [&](const char* names, auto& value, const char* what, const char* meaning)
    { return command.add_option(names, value, meaning)->type_name(what); };
    add("--truth", job.truth, "FILE", "poses to judge by: TUM, or a rawlog");
    add("-o,--output", job.folder, "FOLDER", "where the results go; default: out/tune-<name>");
    command.add_flag("--overwrite", job.may_overwrite, "write into a folder that is not empty");
    add("--budget-ms", job.budget_ms, "MS", "for 99 % of the scans; default 20")
        ->check(CLI::PositiveNumber);
    add("--seeds", job.seeds, "N", "runs of each setting; the worst counts; default 3")
        ->check(CLI::Range(1, 1000));
    add("--first", job.first_scans, "N", "use this many scans");
    add("-c,--config", flags->config_file, "FILE.ini", "what to start from");
    add("--set", flags->sets, "Section.key=value", "set any option; may be given again")
        ->allow_extra_args(false);
    command.add_flag("--no-odometry", flags->no_odometry, "leave the log's odometry aside");
    command.add_flag("--quiet", flags->quiet, "print errors only");
    command.footer(footer);
    return [flags] { return tune_with(*flags); };
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/map/option_text.h>
#include <unistd.h>

#include <iostream>
#include <memory>

#include "exit_code.h"
#include "run/output_folder.h"
#include "run/run_job.h"
#include "run/stop_signals.h"
#include "usage_error.h"
#include "verbs.h"

namespace rtob
{
namespace
{
/// The flags as typed; empty where not given.
struct RunFlags
{
    std::string log, config_file, folder, seed, density, first, skip, map, initial_pose;
    std::vector<std::string> sets;
    std::string wish = "driven";
    bool overwrite = false, no_odometry = false, simple_map = false, guard = false, quiet = false,
         localize = false;
};

constexpr const char* footer =
    "LOG is an MRPT rawlog (either format) or a CARMEN log, plain or packed by gzip or bzip2.\n"
    "Flags win over the .ini; rtob-slam options lists its keys.\n"
    "The folder gets trajectory.tum (the poses as they were told), trajectory_final.tum (the\n"
    "path as the finished map has it), poses.csv, timing.csv, map.png, map.pgm + map.yaml,\n"
    "map.ply, map.rtob, summary.txt, summary.json and config.effective.ini.\n"
    "Ctrl-C ends the run and writes what there is; a second one, later, kills it.\n"
    "Exit codes: 0 ok; 1 failed, or ended early by a signal or a damaged log (what was\n"
    "computed before is written); 2 wrong usage; 3 finished, but lost at the end.";

std::uint64_t count_of(const char* flag, const std::string& text)
{
    std::uint64_t count = 0;
    try
    {
        parse_option(text, count);
    }
    catch (const std::invalid_argument& error)
    {
        throw UsageError(std::string(flag) + ": " + error.what());
    }
    return count;
}

std::vector<OptionFlag> option_flags(const RunFlags& flags)
{
    auto options = parse_set_flags(flags.sets);
    if (!flags.seed.empty()) options.push_back({"--seed", "Run", "seed", flags.seed});
    if (!flags.density.empty())
        options.push_back({"--density", "Density", "density", flags.density});
    if (!flags.map.empty()) options.push_back({"--map", "Map", "file", flags.map});
    if (flags.localize) options.push_back({"--localize", "Map", "localize", "true"});
    if (!flags.initial_pose.empty())
        options.push_back({"--initial-pose", "Map", "initial_pose", flags.initial_pose});
    if (flags.no_odometry) options.push_back({"--no-odometry", "Run", "use_odometry", "false"});
    return options;
}

RunJob job_of(const RunFlags& flags)
{
    RunJob job;
    job.log = flags.log;
    job.config_file = flags.config_file;
    job.folder = flags.folder.empty() ? default_output_folder(flags.log).string() : flags.folder;
    job.may_overwrite = flags.overwrite;
    job.wants_simple_map = flags.simple_map;
    if (!flags.first.empty()) job.limits.first_scans = count_of("--first", flags.first);
    if (job.limits.first_scans == 0) throw UsageError("--first: must be at least 1");
    if (!flags.skip.empty()) job.limits.skip_scans = count_of("--skip", flags.skip);
    if (flags.guard) job.guard_wish = parse_guard_wish(flags.wish);
    job.config = load_run_config(flags.config_file, option_flags(flags));
    job.limits.use_odometry = job.config.run.use_odometry;
    return job;
}

/// Says on stderr what is wrong with a run that has results nevertheless.
int judge(const RunSummary& summary, const std::string& folder)
{
    const auto say = [](const std::string& what) { std::cerr << "rtob-slam: " << what << "\n"; };
    const std::string written = " What was computed before is in " + folder + ".";
    if (summary.run.end == RunEnd::DamagedLog)
        say(summary.run.damage + written);
    else if (summary.run.end == RunEnd::Stopped)
        say("ended by a signal." + written);
    else if (summary.map_scans == 0)
        say("none of the " + std::to_string(summary.counters.scans()) +
            " scans could be used: see beams and scans in " + folder +
            "/summary.txt, and check [ScanFilter] and the log's ranges.");
    else if (!is_lost(summary.final_state))
        return kExitOk;
    else
    {
        say("lost at the end of the run; the column state of " + folder +
            "/poses.csv says since when.");
        return kExitLost;
    }
    return kExitFailed;
}

int run(const RunFlags& flags)
{
    const RunJob job = job_of(flags);
    ProgressLine progress(std::cerr, !flags.quiet && isatty(STDERR_FILENO) != 0);
    const StopSignals signals;
    const RunSummary summary = do_run(job, progress, StopSignals::requested);
    if (!flags.quiet) std::cout << "Results in " << job.folder << "\n";
    std::cout << quotable_line(summary) << std::endl;
    return judge(summary, job.folder);
}
}  // namespace

VerbAction declare_run(CLI::App& command)
{
    const auto flags = std::make_shared<RunFlags>();
    command.add_option("LOG", flags->log, "the log to read")->type_name("")->required();
    const auto add = [&](const char* names, auto& value, const char* what, const char* meaning)
    { return command.add_option(names, value, meaning)->type_name(what); };
    add("-c,--config", flags->config_file, "FILE.ini", "what differs from the defaults");
    add("-o,--output", flags->folder, "FOLDER", "where the results go; default: out/<log>");
    command.add_flag("--overwrite", flags->overwrite, "write into a folder that is not empty");
    add("--seed", flags->seed, "N", "seed of all random draws: [Run] seed");
    command.add_flag("--no-odometry", flags->no_odometry, "leave the log's odometry aside");
    add("--density", flags->density, "NAME",
        "uniform, interval, window, forgetting or revisit: [Density] density");
    add("--map", flags->map, "FILE.rtob", "go on in the map of an earlier run: [Map] file");
    command.add_flag("--localize", flags->localize, "with --map: leave the map as it is");
    add("--initial-pose", flags->initial_pose, "X,Y,YAW_DEG",
        "where in --map the vehicle is; without it, it is looked for everywhere");
    add("--first", flags->first, "N", "end after this many scans");
    add("--skip", flags->skip, "N", "pass over this many scans at the start");
    add("--set", flags->sets, "Section.key=value", "set any option; may be given again")
        ->allow_extra_args(false);
    command.add_flag(
        "--simplemap", flags->simple_map,
        "write map.simplemap for MRPT too; holds all its scans in memory");
    auto* guard = command.add_flag(
        "--guard", flags->guard,
        "write guard.csv: what the obstacle guard would have commanded after each scan");
    add("--wish", flags->wish, "WISH",
        "of the pilot, for --guard: driven (default), or m/s ahead and left, e.g. 0.5,0")
        ->needs(guard);
    command.add_flag("--quiet", flags->quiet, "no progress, just the last line");
    command.footer(footer);
    return [flags] { return run(*flags); };
}
}  // namespace rtob

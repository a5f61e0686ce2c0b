// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/enum_names.h>
#include <rtob/map/option_text.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "compare/child_process.h"
#include "compare/compare_job.h"
#include "compare/variant_run.h"
#include "exit_code.h"
#include "run/output_folder.h"
#include "usage_error.h"
#include "verbs.h"

namespace rtob
{
namespace
{
namespace fs = std::filesystem;

/// The flags as typed; empty where not given.
struct CompareFlags
{
    std::vector<std::string> logs, truths, densities, mrpt_files, variants, sets;
    std::string config_file, folder, first, skip, time_limit, repeats = "3", seeds = "3";
    bool overwrite = false, no_odometry = false, quiet = false;
};

constexpr const char* footer =
    "Runs RTOB-SLAM, MRPT's ICP-SLAM (as shipped, with dense settings, with Levenberg-Marquardt,\n"
    "against a grid), the paper's recipe with PCL where that was built, and the odometry alone:\n"
    "the same scans and odometry, each run in a process of its own. Variants: rtob-<density>,\n"
    "mrpt-stock, mrpt-dense, mrpt-lm, mrpt-grid, pcl, odometry. A variant that fails has its\n"
    "reason in its row.\n"
    "The folder gets report.html (all in one file), report.md, results.csv, and runs/ with every\n"
    "run's trajectory.tum, timing.csv, map.png, scans.png. docs/compare.md explains the report.\n"
    "Exit codes: 0 ok, also where variants failed; 1 the log or the truth cannot be used, or "
    "every\n"
    "variant failed; 2 wrong usage.";

std::uint64_t positive(const char* flag, const std::string& text)
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
    if (count == 0) throw UsageError(std::string(flag) + ": must be at least 1");
    return count;
}

int small_count(const char* flag, const std::string& text)
{
    constexpr std::uint64_t most = 1000;
    const auto count = positive(flag, text);
    if (count > most) throw UsageError(std::string(flag) + ": must be at most 1000");
    return static_cast<int>(count);
}

/// As it would be typed again in a shell.
std::string shell_word(const std::string& word)
{
    const bool is_plain = word.find_first_not_of(
                              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                              "-_./=,:+") == std::string::npos;
    if (is_plain && !word.empty()) return word;
    std::string quoted = "'";
    for (const char letter : word)
        quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return quoted + "'";
}

std::string command_for(const CompareFlags& flags, const std::string& log, const std::string& truth)
{
    std::string command = "rtob-slam compare " + shell_word(log);
    const auto add = [&](const std::string& flag, const std::string& value)
    {
        if (!value.empty()) command += " " + flag + " " + shell_word(value);
    };
    add("--truth", truth);
    add("--config", flags.config_file);
    for (const auto& name : flags.densities) add("--density", name);
    for (const auto& name : flags.variants) add("--variant", name);
    for (const auto& file : flags.mrpt_files) add("--mrpt", file);
    for (const auto& set : flags.sets) add("--set", set);
    if (flags.no_odometry) command += " --no-odometry";
    add("--first", flags.first);
    add("--skip", flags.skip);
    add("--repeats", flags.repeats);
    add("--seeds", flags.seeds);
    add("--time-limit", flags.time_limit);
    return command;
}

fs::path folder_for(const CompareFlags& flags, const std::string& log)
{
    const fs::path name = default_output_folder(log).filename();
    if (flags.folder.empty()) return fs::path("out") / ("compare-" + name.string());
    return flags.logs.size() == 1 ? fs::path(flags.folder) : fs::path(flags.folder) / name;
}

CompareJob job_of(const CompareFlags& flags, std::size_t index)
{
    CompareJob job;
    job.log = flags.logs[index];
    if (!flags.truths.empty()) job.truth = flags.truths[index];
    job.folder = folder_for(flags, job.log);
    job.may_overwrite = flags.overwrite;
    job.config_file = flags.config_file;
    job.sets = flags.sets;
    if (flags.no_odometry) job.sets.emplace_back("Run.use_odometry=false");
    if (!flags.first.empty()) job.limits.first_scans = positive("--first", flags.first);
    if (!flags.skip.empty()) job.limits.skip_scans = positive("--skip", flags.skip);
    job.repeats = small_count("--repeats", flags.repeats);
    job.seeds = small_count("--seeds", flags.seeds);
    constexpr double minute_s = 60;
    if (!flags.time_limit.empty())
        job.time_limit_s =
            minute_s * static_cast<double>(positive("--time-limit", flags.time_limit));
    const RunConfig config = load_run_config(job.config_file, parse_set_flags(job.sets));
    job.limits.use_odometry = config.run.use_odometry;
    job.choice = {flags.densities, flags.mrpt_files, flags.variants};
    if (job.choice.densities.empty())
        job.choice.densities.emplace_back(name_of(config.slam.density.density));
    job.command = command_for(flags, job.log, job.truth);
    return job;
}

void check(const CompareFlags& flags)
{
    if (!flags.truths.empty() && flags.truths.size() != flags.logs.size())
        throw UsageError(
            "--truth: give one file for each log, in the same order; there are " +
            std::to_string(flags.logs.size()) + " logs and " + std::to_string(flags.truths.size()) +
            " truths");
    for (const auto& density : flags.densities) try
        {
            static_cast<void>(parse_enum<Density>(density));
        }
        catch (const std::invalid_argument& error)
        {
            throw UsageError(std::string("--density: ") + error.what());
        }
}

bool has_result(const Comparison& comparison)
{
    for (const auto& variant : comparison.variants)
        if (figures_of(variant).results > 0) return true;
    return false;
}

int compare(const CompareFlags& flags)
{
    check(flags);
    int exit_code = kExitOk;
    for (std::size_t i = 0; i < flags.logs.size(); ++i)
    {
        const CompareJob job = job_of(flags, i);
        const auto say = [&](const std::string& line)
        {
            if (!flags.quiet) std::cerr << line << "\n";
        };
        const Comparison comparison = do_compare(job, say);
        if (!has_result(comparison)) exit_code = kExitFailed;
        std::cout << "Report in " << (fs::path(job.folder) / "report.html").string() << std::endl;
    }
    return exit_code;
}
}  // namespace

VerbAction declare_compare(CLI::App& command)
{
    const auto flags = std::make_shared<CompareFlags>();
    const auto add = [&](const char* names, auto& value, const char* what, const char* meaning)
    { return command.add_option(names, value, meaning)->type_name(what); };
    add("LOG", flags->logs, "", "the log or logs; one report for each")->required();
    add("--truth", flags->truths, "FILE",
        "relations, or poses (TUM, a rawlog), to judge by; once for each log, in their order")
        ->allow_extra_args(false);
    add("-o,--output", flags->folder, "FOLDER",
        "where the report goes; default: out/compare-<log>");
    command.add_flag("--overwrite", flags->overwrite, "write into a folder that is not empty");
    add("--density", flags->densities, "NAME", "a RTOB variant for each; default: the config's")
        ->allow_extra_args(false);
    add("--variant", flags->variants, "NAME", "run this variant only; may be given again")
        ->allow_extra_args(false);
    add("--mrpt", flags->mrpt_files, "FILE.ini", "compare this setting of icp-slam, too")
        ->allow_extra_args(false);
    add("--repeats", flags->repeats, "N", "runs of each variant; default 3");
    add("--seeds", flags->seeds, "N",
        "seeds of variants that draw at random; beyond --repeats for RTOB alone; "
        "default 3");
    add("--time-limit", flags->time_limit, "MIN",
        "end a run that takes longer; its row says so; default: none");
    add("-c,--config", flags->config_file, "FILE.ini", "RTOB's; its lasers and beams are for all");
    add("--set", flags->sets, "Section.key=value", "set any option of RTOB")
        ->allow_extra_args(false);
    command.add_flag("--no-odometry", flags->no_odometry, "leave the log's odometry aside");
    add("--first", flags->first, "N", "end after this many scans");
    add("--skip", flags->skip, "N", "pass over this many scans at the start");
    command.add_flag("--quiet", flags->quiet, "no progress");
    command.footer(footer);
    return [flags] { return compare(*flags); };
}

VerbAction declare_compare_run(CLI::App& command)
{
    const auto file = std::make_shared<std::string>();
    command.add_option("JOB", *file, "the job.json of a run")->type_name("")->required();
    return [file]
    {
        end_with_parent();
        run_variant(read_job(*file), make_variant);
        return kExitOk;
    };
}
}  // namespace rtob

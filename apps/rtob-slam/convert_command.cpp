// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "convert/convert_job.h"
#include "exit_code.h"
#include "run/stop_signals.h"
#include "usage_error.h"
#include "verbs.h"

namespace rtob
{
namespace
{
struct ConvertFlags
{
    ConvertJob job;
    std::string to;
    bool quiet = false;
};

constexpr const char* footer =
    "LOG is an MRPT rawlog (either format), a CARMEN log or a TUM file of poses, plain or packed "
    "by\n"
    "gzip or bzip2. OUTPUT's name says what is written:\n"
    "  *.rawlog                     observations, for MRPT's programs\n"
    "  *.log *.clf (.gz, .bz2)      CARMEN: ROBOTLASER1 and ODOM lines\n"
    "  *.tum (.gz, .bz2)            the log's robot poses or, without any, its odometry\n"
    "Ranges that mean no return are found by themselves where a log does not tell them. What the\n"
    "new format cannot hold is counted and listed, or refused.\n"
    "Exit codes: 0 ok; 1 failed, nothing is written (with --keep-part: what comes before the\n"
    "damage is); 2 wrong usage.";

int convert(ConvertFlags flags)
{
    auto& job = flags.job;
    job.target = convert_target(job.output, flags.to);
    const StopSignals signals;
    const Conversion conversion = convert_log(job, StopSignals::requested);
    if (!flags.quiet) std::cout << conversion_text(job, conversion);
    if (conversion.damage.empty()) return kExitOk;
    std::cerr << "rtob-slam: " << conversion.damage << " What comes before is in " << job.output
              << ".\n";
    return kExitFailed;
}
}  // namespace

VerbAction declare_convert(CLI::App& command)
{
    const auto flags = std::make_shared<ConvertFlags>();
    auto& job = flags->job;
    command.add_option("LOG", job.log, "the log to read")->type_name("")->required();
    command.add_option("OUTPUT", job.output, "the file to write")->type_name("")->required();
    command.add_option("--to", flags->to, "rawlog, carmen or tum; default: by OUTPUT's name")
        ->type_name("FORMAT");
    command.add_option("--lasers", job.choice.lasers, "take just the lasers with these labels")
        ->type_name("LABEL,LABEL")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        .add_option(
            "--poses", job.choice.poses, "take just odometry and robot poses with these labels")
        ->type_name("LABEL,LABEL")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        .add_option(
            "--max-range", flags->job.choice.max_range_m, "ranges from here on mean no return")
        ->type_name("METRES")
        ->check(CLI::PositiveNumber);
    command.add_flag(
        "--odometry", job.poses_are_odometry,
        "the poses of the TUM file (read or written) are odometry, not robot poses");
    command.add_flag("--overwrite", job.may_overwrite, "replace OUTPUT if it exists");
    command.add_flag("--keep-part", job.keep_part, "of a damaged log, convert what can be read");
    command.add_flag("--quiet", flags->quiet, "print errors only");
    command.footer(footer);
    return [flags] { return convert(*flags); };
}
}  // namespace rtob

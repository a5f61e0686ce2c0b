// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "endure/endurance.h"
#include "exit_code.h"
#include "run/run_options.h"
#include "verbs.h"

namespace rtob
{
namespace
{
struct EndureFlags
{
    EnduranceJob job;
    std::string config_file;
    std::vector<std::string> sets;
};

constexpr const char* footer =
    "Flies WORLD (share/worlds) without a log and prints what every block of scans cost: with\n"
    "--set Map.max_points=N the columns of map and memory stay where they are for ever.\n"
    "24 hours of an RPLidar are 864000 scans.";

int run(const EndureFlags& flags)
{
    EnduranceJob job = flags.job;
    job.slam = load_run_config(flags.config_file, parse_set_flags(flags.sets)).slam;
    std::cout << endurance_header() << std::flush;
    endure(
        job, [](const EnduranceBlock& block) { std::cout << endurance_line(block) << std::flush; });
    return kExitOk;
}
}  // namespace

VerbAction declare_endure(CLI::App& command)
{
    const auto flags = std::make_shared<EndureFlags>();
    command.add_option("WORLD", flags->job.world, "the world to fly in")->type_name("")->required();
    const auto add = [&](const char* names, auto& value, const char* what, const char* meaning)
    { return command.add_option(names, value, meaning)->type_name(what); };
    add("--scans", flags->job.scans, "N", "to fly; default 36000, an hour");
    add("--every", flags->job.every_scans, "N", "scans of a line; default 3600")
        ->check(CLI::PositiveNumber);
    add("--seed", flags->job.seed, "N", "of noise and turbulence; default 1");
    add("-c,--config", flags->config_file, "FILE.ini", "what differs from the defaults");
    add("--set", flags->sets, "Section.key=value", "set any option; may be given again")
        ->allow_extra_args(false);
    command.footer(footer);
    return [flags] { return run(*flags); };
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "exit_code.h"
#include "recovery/recovery_text.h"
#include "run/run_options.h"
#include "verbs.h"

namespace rtob
{
namespace
{
struct RecoveryFlags
{
    std::string log, config_file;
    std::vector<std::string> sets;
    RelocaliseTrials relocalise;
    KidnapTrials carried;
    std::uint64_t covered = 20, seed = 1;
    std::uint64_t first = std::numeric_limits<std::uint64_t>::max();
};

constexpr const char* footer =
    "Runs over the log once, then tries in the map of that run: the vehicle wakes up at random\n"
    "scans; tracks and is carried elsewhere; tracks and its laser is covered for a while. It has\n"
    "no odometry, and the map never holds the scans of a trial nor those 2 s around them.\n"
    "docs/maps.md has the figures of the real logs.";

int run(const RecoveryFlags& flags)
{
    const SlamOptions slam = load_run_config(flags.config_file, parse_set_flags(flags.sets)).slam;
    const DrivenLog driven = drive_log(flags.log, slam, flags.first);
    std::cout << flags.log << ": " << driven.scans.size() << " scans tracked; map of "
              << driven.map.scans().size() << " scans, " << driven.map.size() << " points\n";
    RelocaliseTrials relocalise = flags.relocalise;
    relocalise.seed = flags.seed;
    std::cout << relocalise_text(relocalise_trials(driven, slam, relocalise), relocalise)
              << std::flush;
    KidnapTrials kidnap = flags.carried;
    kidnap.seed = flags.seed;
    std::cout << kidnap_text(kidnap_trials(driven, slam, kidnap), kidnap) << std::flush;
    kidnap.mishap = Mishap::Covered;
    kidnap.count = flags.covered;
    std::cout << kidnap_text(kidnap_trials(driven, slam, kidnap), kidnap) << std::flush;
    return kExitOk;
}
}  // namespace

VerbAction declare_recovery(CLI::App& command)
{
    const auto flags = std::make_shared<RecoveryFlags>();
    command.add_option("LOG", flags->log, "the log to read")->type_name("")->required();
    const auto add = [&](const char* names, auto& value, const char* what, const char* meaning)
    { return command.add_option(names, value, meaning)->type_name(what); };
    add("-c,--config", flags->config_file, "FILE.ini", "what differs from the defaults");
    add("--set", flags->sets, "Section.key=value", "set any option; may be given again")
        ->allow_extra_args(false);
    add("--trials", flags->relocalise.count, "N", "times to wake up somewhere; default 100");
    add("--kidnaps", flags->carried.count, "N", "times to be carried away; default 50");
    add("--apart", flags->carried.least_m, "M", "how far it is carried at least; default 5");
    add("--covers", flags->covered, "N", "times to be covered; default 20");
    add("--seed", flags->seed, "N", "of the choice of scans");
    add("--first", flags->first, "N", "take only so many scans of the log");
    command.footer(footer);
    return [flags] { return run(*flags); };
}
}  // namespace rtob

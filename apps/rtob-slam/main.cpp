// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/nearest_name.h>
#include <rtob/map/rtob_map.h>

#include <array>
#include <iostream>
#include <string>
#include <vector>

#include "exit_code.h"
#include "usage_error.h"
#include "verbs.h"

namespace
{
struct Verb
{
    const char* name;
    const char* summary;
    rtob::VerbAction (*declare)(CLI::App&);
};

constexpr std::array<Verb, 12> verbs{
    {{"run", "turn a laser log into a trajectory and a map", rtob::declare_run},
     {"check", "look for faults in a log, and suggest an .ini", rtob::declare_check},
     {"convert", "turn a log into a rawlog, a CARMEN log or poses", rtob::declare_convert},
     {"eval", "score a trajectory against the truth: a trajectory or relations",
      rtob::declare_eval},
     {"compare", "RTOB-SLAM beside MRPT's ICP-SLAM on your log: a report", rtob::declare_compare},
     {"compare-run", "", rtob::declare_compare_run},
     {"simulate", "fly a simulated world and write log and truth", rtob::declare_simulate},
     {"emulate", "a laser that is none: plays a log to a driver", rtob::declare_emulate},
     {"tune", "find settings for a time budget", rtob::declare_tune},
     {"recovery", "lose the vehicle on a log, and count how it finds itself again",
      rtob::declare_recovery},
     {"endure", "fly a simulated world for as long as you like, and watch memory and time",
      rtob::declare_endure},
     {"options", "list every key of the .ini with its default", rtob::declare_options}}};

struct DeclaredVerb
{
    CLI::App* command;
    rtob::VerbAction action;
};

/// CLI11 names what it does not know, but not what was probably meant.
std::string with_suggestion(const CLI::App& command, const CLI::ExtrasError& error)
{
    std::vector<std::string> known;
    for (const auto* option : command.get_options())
        for (const auto& name : option->get_lnames()) known.push_back("--" + name);
    for (const auto& word : command.remaining())
        if (word.rfind("--", 0) == 0)
        {
            const auto flag = word.substr(0, word.find('='));
            return "unknown flag " + flag + rtob::suggestion(flag, known);
        }
    return error.what();
}

void refuse_unknown_verb(int argc, const char* const* argv)
{
    if (argc < 2 || argv[1][0] == '-') return;
    std::vector<std::string> known;
    for (const auto& verb : verbs)
    {
        if (std::string(verb.name) == argv[1]) return;
        known.emplace_back(verb.name);
    }
    throw rtob::UsageError(
        "unknown verb '" + std::string(argv[1]) + "'" + rtob::suggestion(argv[1], known));
}

int run_verb(CLI::App& program, int argc, const char* const* argv)
{
    std::vector<DeclaredVerb> declared;
    for (const auto& verb : verbs)
    {
        auto* command = program.add_subcommand(verb.name, verb.summary);
        if (*verb.summary == '\0') command->group("");  // in no help: for the program itself
        declared.push_back({command, verb.declare(*command)});
    }
    refuse_unknown_verb(argc, argv);
    if (argc < 2)
    {
        std::cerr << program.help();
        return rtob::kExitUsage;
    }
    try
    {
        program.parse(argc, argv);
    }
    catch (const CLI::Success& help_or_version)
    {
        return program.exit(help_or_version);
    }
    catch (const CLI::ExtrasError& error)
    {
        for (const auto& [command, action] : declared)
            if (command->parsed()) throw rtob::UsageError(with_suggestion(*command, error));
        throw rtob::UsageError(error.what());
    }
    catch (const CLI::ParseError& error)
    {
        throw rtob::UsageError(error.what());
    }
    for (const auto& [command, action] : declared)
        if (command->parsed()) return action();
    throw rtob::UsageError("name a verb");
}
}  // namespace

int main(int argc, char** argv)
{
    CLI::App program("RTOB-SLAM: localisation and mapping with one 2D laser.", "rtob-slam");
    program.set_version_flag("--version", "rtob-slam " RTOB_VERSION);
    program.footer(
        "rtob-slam VERB --help explains a verb.\n"
        "Exit codes: 0 ok; 1 failed, or ended early; 2 wrong usage; 3 finished, but lost.");
    try
    {
        rtob::register_classes();
        return run_verb(program, argc, argv);
    }
    catch (const rtob::UsageError& error)
    {
        std::cerr << "rtob-slam: " << error.what() << "\nrtob-slam --help shows what there is.\n";
        return rtob::kExitUsage;
    }
    catch (const std::exception& error)
    {
        std::cerr << "rtob-slam: " << error.what() << "\n";
        return rtob::kExitFailed;
    }
}

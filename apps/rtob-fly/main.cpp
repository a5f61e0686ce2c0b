// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/enum_names.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <thread>

#include "campaign.h"
#include "flight_picture.h"
#include "tally_text.h"

namespace rtob::fly
{
namespace
{
enum ExitCode
{
    kOk = 0,
    kFailed = 1,
    kUsage = 2
};

struct Flags
{
    std::string world = "flat", pilot = "scripted", avoider = "guard", folder = "out/fly";
    std::uint64_t seed = 1, flights = 240, first = 0;
    int doors = 60;
    double duration_s = 60, field_of_view_deg = 360;
    bool drifts = false;
    unsigned jobs = 1;
};

constexpr const char* footer =
    "rtob-fly show       flies once and draws flight.png and strip.png\n"
    "rtob-fly campaign   flies many times; exit code 1 when anything was touched\n"
    "rtob-fly compare    the same flights under each avoider, and doors: a Markdown table\n"
    "Worlds: room, garage, flat, maze. Pilots: scripted, random, malicious.\n"
    "Avoiders: guard, px4, ardupilot, mrpt-nd, mrpt-fulleval (with libmrpt-nav-dev), none.";

int show(const Flags& flags)
{
    FlightSetup setup;
    setup.avoider = flags.avoider;
    setup.pilot = parse_enum<PilotKind>(flags.pilot);
    setup.seed = flags.seed;
    setup.duration_s = flags.duration_s;
    setup.hardship.field_of_view_deg = flags.field_of_view_deg;
    setup.limits = fly_limits();
    setup.options = fly_options();
    const FlyWorld world = make_fly_world(flags.world);
    const FlightResult result = fly(world, setup, 0.1);
    std::filesystem::create_directories(flags.folder);
    write_flight_picture(flags.folder + "/flight.png", world, setup, result);
    write_flight_strip(flags.folder + "/strip.png", world, setup, result, 12);
    CampaignTally tally;
    tally.add(flags.seed, setup, result);
    std::cout << tally_head() << tally_row(flags.world, tally) << "pictures in " << flags.folder
              << "\n";
    return result.contacts == 0 ? kOk : kFailed;
}

CampaignPlan plan_of(const Flags& flags)
{
    CampaignPlan plan;
    plan.avoider = flags.avoider;
    plan.worlds = fly_world_names();
    plan.flights = flags.flights;
    plan.first = flags.first;
    plan.duration_s = flags.duration_s;
    plan.holds_place = !flags.drifts;
    plan.field_of_view_deg = flags.field_of_view_deg;
    plan.jobs = flags.jobs > 0 ? flags.jobs : std::thread::hardware_concurrency();
    return plan;
}

CampaignTally run_with_progress(const CampaignPlan& plan)
{
    const bool is_terminal = isatty(STDERR_FILENO) != 0;
    const auto progress = [&](std::uint64_t done)
    {
        if (is_terminal)
            std::cerr << '\r' << done << " of " << plan.flights << " flights" << std::flush;
    };
    CampaignTally tally = run_campaign(plan, progress);
    if (is_terminal) std::cerr << "\r\033[K";
    return tally;
}

int campaign(const Flags& flags)
{
    const CampaignTally tally = run_with_progress(plan_of(flags));
    std::cout << tally_head() << tally_row(flags.avoider, tally) << tally_notes(tally);
    return tally.contacts == 0 ? kOk : kFailed;
}

int compare(const Flags& flags)
{
    std::cout << tally_head();
    for (const std::string& name : avoider_names())
    {
        CampaignPlan plan = plan_of(flags);
        plan.avoider = name;
        std::cout << tally_row(
                         name, run_with_progress(plan),
                         try_doors(name, flags.doors, flags.field_of_view_deg))
                  << std::flush;
    }
    return kOk;
}

int run(int argc, char** argv)
{
    CLI::App program("Flights under the obstacle guard in the simulator.", "rtob-fly");
    program.footer(footer);
    program.require_subcommand(1);
    Flags flags;
    const auto add = [&](CLI::App* verb)
    {
        verb->add_option("--seed", flags.seed, "of a flight")->type_name("N");
        verb->add_option("--duration", flags.duration_s, "of a flight")
            ->type_name("SECONDS")
            ->check(CLI::PositiveNumber);
        verb->add_option("--fov", flags.field_of_view_deg, "what the laser sees around its front")
            ->type_name("DEGREES")
            ->check(CLI::Range(30, 360));
        return verb;
    };
    const auto add_many = [&](CLI::App* verb)
    {
        add(verb)->add_option("--flights", flags.flights, "how many")->type_name("N");
        verb->add_option("--first", flags.first, "number of the first one")->type_name("N");
        verb->add_flag("--drift", flags.drifts, "no position hold: gusts carry the vehicle away");
        verb->add_option("--jobs", flags.jobs, "at a time; 0: one a core")->type_name("N");
        return verb;
    };
    auto* show_verb = add(program.add_subcommand("show", "one flight, with pictures"));
    show_verb->add_option("WORLD", flags.world)->check(CLI::IsMember(fly_world_names()));
    show_verb->add_option("--pilot", flags.pilot)
        ->check(CLI::IsMember({"scripted", "random", "malicious"}));
    show_verb->add_option("-o,--output", flags.folder, "for the pictures")->type_name("FOLDER");
    auto* campaign_verb = add_many(program.add_subcommand("campaign", "many flights, counted"));
    for (auto* verb : {show_verb, campaign_verb})
        verb->add_option("--avoider", flags.avoider)->check(CLI::IsMember(avoider_names()));
    auto* compare_verb = add_many(program.add_subcommand("compare", "beside other rules"));
    compare_verb->add_option("--doors", flags.doors, "flights at doors")->type_name("N");
    try
    {
        program.parse(argc, argv);
    }
    catch (const CLI::Success& help)
    {
        return program.exit(help);
    }
    catch (const CLI::ParseError& error)
    {
        program.exit(error);
        return kUsage;
    }
    if (show_verb->parsed()) return show(flags);
    return campaign_verb->parsed() ? campaign(flags) : compare(flags);
}
}  // namespace
}  // namespace rtob::fly

int main(int argc, char** argv)
{
    try
    {
        return rtob::fly::run(argc, argv);
    }
    catch (const std::exception& error)
    {
        std::cerr << "rtob-fly: " << error.what() << "\n";
        return 1;
    }
}

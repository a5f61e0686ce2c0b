// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <rtob/drivers/register_drivers.h>
#include <rtob/drivers/unix_time.h>
#include <rtob/map/config_file.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>

#include "check.h"
#include "exit_code.h"
#include "live_run.h"
#include "run/stop_signals.h"

namespace
{
constexpr const char* footer =
    "CONFIG.ini holds a section for each sensor, as for rawlog-grabber, and the sections of\n"
    "rtob-slam run; docs/onboard.md leads through it. Ends with SIGTERM or SIGINT (Ctrl-C), and\n"
    "then writes map, trajectory and summary beside the capture.\n"
    "Exit codes: 0 ok; 1 failed; 2 wrong usage; 3 lost at the end.";

int judge(const rtob::LiveSummary& summary)
{
    std::cout << rtob::live_line(summary) << "\nResults in " << summary.folder << std::endl;
    for (const auto& problem : summary.problems)
        std::cerr << "rtob-onboard: " << problem << std::endl;
    if (!summary.problems.empty() || !summary.capture.problem.empty()) return rtob::kExitFailed;
    if (summary.map_scans == 0)
    {
        std::cerr << "rtob-onboard: no scan could be used; --check shows what comes in.\n";
        return rtob::kExitFailed;
    }
    return rtob::is_lost(summary.final_state) ? rtob::kExitLost : rtob::kExitOk;
}

int run(const std::string& file, bool only_check)
{
    const auto ini = rtob::open_config(file);
    const auto config = rtob::load_onboard_config(ini);
    const rtob::StopSignals signals;
    if (!only_check)
        return judge(rtob::run_live(config, ini, std::cout, rtob::StopSignals::requested));
    const bool ok = rtob::check_onboard(config, ini, std::cout, rtob::StopSignals::requested);
    return ok ? rtob::kExitOk : rtob::kExitFailed;
}
}  // namespace

int main(int argc, char** argv)
{
    // Some of MRPT's functions wait for a key when something fails: there is none to press.
    if (const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC); nothing >= 0)
        dup2(nothing, STDIN_FILENO);
    rtob::keep_time_from_now_on();
    std::signal(SIGPIPE, SIG_IGN);  // a laser that hangs up while MRPT writes to it
    CLI::App program(
        "Localises and maps live, with any sensor of MRPT; no screen needed.", "rtob-onboard");
    std::string file;
    bool only_check = false;
    program.add_option("CONFIG.ini", file, "what sensors there are")->type_name("")->required();
    program.add_flag("--check", only_check, "open everything, tell what is seen, and leave");
    program.set_version_flag("--version", "rtob-onboard " RTOB_VERSION);
    program.footer(footer);
    try
    {
        program.parse(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
        const int code = program.exit(error);
        return code == 0 ? rtob::kExitOk : rtob::kExitUsage;
    }
    try
    {
        rtob::register_classes();
        rtob::register_drivers();
        return run(file, only_check);
    }
    catch (const std::exception& error)
    {
        std::cerr << "rtob-onboard: " << rtob::plain_message(error) << std::endl;
        return rtob::kExitFailed;
    }
}

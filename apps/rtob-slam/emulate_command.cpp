// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "emulate/emulate_job.h"
#include "exit_code.h"
#include "run/stop_signals.h"
#include "verbs.h"

namespace rtob
{
namespace
{
constexpr const char* footer =
    "For trials of rtob-onboard, rawlog-grabber or any driver without hardware. An RPLidar is a\n"
    "pseudo-terminal behind a link; the others are TCP ports of this computer. Scans of a world\n"
    "come from the log that rtob-slam simulate writes. Ends with SIGINT (Ctrl-C) or SIGTERM.\n"
    "Exit codes: 0 ok; 1 failed; 2 wrong usage.";
}  // namespace

VerbAction declare_emulate(CLI::App& command)
{
    const auto job = std::make_shared<EmulateJob>();
    command
        .add_option(
            "DEVICE", job->device,
            "rplidar-a1, rplidar-a2, rplidar-a3, rplidar-s2, hokuyo or sick-tim561")
        ->type_name("")
        ->required()
        ->check(CLI::IsMember(emulated_devices()));
    command.add_option("LOG", job->log, "what it sees: the first laser's scans, again and again")
        ->type_name("")
        ->required();
    command
        .add_option(
            "--port", job->port,
            "an RPLidar's: the link to make, default ttyLaser; else a TCP port, default any")
        ->type_name("NAME");
    command
        .add_option(
            "--faults", job->faults_every_s,
            "a fault of line or device each so many seconds: garbage, half packets, stalls, ...")
        ->type_name("SECONDS")
        ->check(CLI::PositiveNumber);
    command.add_option("--seconds", job->seconds, "end after this time")
        ->type_name("SECONDS")
        ->check(CLI::PositiveNumber);
    command.footer(footer);
    return [job]
    {
        const StopSignals signals;
        emulate(*job, std::cout, StopSignals::requested);
        return kExitOk;
    };
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "exit_code.h"
#include "simulate/simulate_job.h"
#include "verbs.h"

namespace rtob
{
namespace
{
constexpr const char* footer =
    "WORLD is a text file that says what stands where and who flies how: share/worlds has some,\n"
    "docs/worlds.md explains them. The log holds observations only: LASER, odometry, IMU, FLOW\n"
    "(optical flow), ALTIMETER; MRPT's programs read it. The truth is the pose of every scan at "
    "its\n"
    "stamp, as TUM, in the world's frame.\n"
    "One world and one seed give the same bytes.\n"
    "Exit codes: 0 ok; 1 failed, nothing is written; 2 wrong usage.";

int simulate_with(SimulateJob job, bool quiet)
{
    if (job.truth.empty()) job.truth = default_truth_file(job.log);
    const SimulatedLog log = simulate(job);
    if (!quiet) std::cout << simulation_text(job, log);
    return kExitOk;
}
}  // namespace

VerbAction declare_simulate(CLI::App& command)
{
    struct Flags
    {
        SimulateJob job;
        bool quiet = false;
    };
    const auto flags = std::make_shared<Flags>();
    auto& job = flags->job;
    command.add_option("WORLD", job.world, "the world to fly in")->type_name("")->required();
    const auto add = [&](const char* names, auto& value, const char* what, const char* meaning)
    { return command.add_option(names, value, meaning)->type_name(what); };
    add("-o,--output", job.log, "LOG.rawlog", "the log to write")->required();
    add("--truth", job.truth, "FILE", "the truth to write; default: LOG.truth.tum");
    add("--seed", job.seed, "N", "of noise and turbulence; default 1");
    add("--duration", job.duration_s, "S", "instead of the world's")->check(CLI::PositiveNumber);
    add("--speed", job.speed_mps, "M/S", "instead of the world's")->check(CLI::PositiveNumber);
    add("--yaw-rate", job.yaw_rate_dps, "DEG/S", "turn all the time, this fast");
    add("--rate", job.rate_hz, "HZ", "of the laser, instead of the world's")
        ->check(CLI::PositiveNumber);
    command.add_flag("--laser-only", job.laser_only, "no odometry, IMU, flow, altimeter");
    command.add_flag("--overwrite", job.may_overwrite, "replace LOG and truth if they exist");
    command.add_flag("--quiet", flags->quiet, "print errors only");
    command.footer(footer);
    return [flags] { return simulate_with(flags->job, flags->quiet); };
}
}  // namespace rtob

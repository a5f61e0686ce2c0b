// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/check_log.h>

#include <iostream>
#include <memory>

#include "check/check_text.h"
#include "exit_code.h"
#include "run/stop_signals.h"
#include "verbs.h"

namespace rtob
{
namespace
{
struct CheckFlags
{
    std::string log;
    bool json = false;
};

constexpr const char* footer =
    "LOG is an MRPT rawlog (either format) or a CARMEN log, plain or packed by gzip or bzip2.\n"
    "PASS: fine. WARN: costs accuracy, or traps other programs. FAIL: run with its defaults would\n"
    "fail or be wrong; the suggested .ini, or the hint, mends it. docs/check.md explains each "
    "line.\n"
    "Exit codes: 0 nothing FAILs; 1 something does, or the log cannot be read; 2 wrong usage.";

int check(const CheckFlags& flags)
{
    const StopSignals signals;
    const auto report = check_log(flags.log, [](double) { return !StopSignals::requested(); });
    std::cout << (flags.json ? check_json(flags.log, report) : check_text(flags.log, report));
    return report.worst() == Severity::Fail ? kExitFailed : kExitOk;
}
}  // namespace

VerbAction declare_check(CLI::App& command)
{
    const auto flags = std::make_shared<CheckFlags>();
    command.add_option("LOG", flags->log, "the log to read")->type_name("")->required();
    command.add_flag("--json", flags->json, "print JSON");
    command.footer(footer);
    return [flags] { return check(*flags); };
}
}  // namespace rtob

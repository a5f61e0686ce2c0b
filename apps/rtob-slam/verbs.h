// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace rtob
{
/// Does what the parsed flags say and returns the exit code.
using VerbAction = std::function<int()>;

/// Each adds its flags to its subcommand and returns its action, to be called after parsing.
VerbAction declare_recovery(CLI::App& command);
VerbAction declare_run(CLI::App& command);
VerbAction declare_check(CLI::App& command);
VerbAction declare_convert(CLI::App& command);
VerbAction declare_endure(CLI::App& command);
VerbAction declare_eval(CLI::App& command);
VerbAction declare_compare(CLI::App& command);
/// One run of a comparison: compare starts it as a process of its own.
VerbAction declare_compare_run(CLI::App& command);
VerbAction declare_simulate(CLI::App& command);
VerbAction declare_emulate(CLI::App& command);
VerbAction declare_tune(CLI::App& command);
VerbAction declare_options(CLI::App& command);
}  // namespace rtob

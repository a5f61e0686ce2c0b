// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/map/options_io.h>

#include <iostream>
#include <memory>

#include "exit_code.h"
#include "run/run_options.h"
#include "verbs.h"

namespace rtob
{
namespace
{
void print_markdown(const RunConfig& config)
{
    std::cout << "# Options\n\n"
                 "Every key of the .ini of `rtob-slam run`, printed by `rtob-slam options "
                 "--markdown` (`./dev docs` writes this file anew). Defaults live in the code: an "
                 ".ini holds only what differs, and an empty one is valid. On the command line: "
                 "`--set Section.key=value`. Unknown sections and keys are refused.\n";
    RunConfig::sections(
        config, [](const char* section, const auto& options)
        { std::cout << "\n"
                    << options_markdown(section, options); });
}
}  // namespace

VerbAction declare_options(CLI::App& command)
{
    const auto markdown = std::make_shared<bool>(false);
    command.add_flag("--markdown", *markdown, "as tables: the text of docs/options.md");
    command.footer("Without a flag: a complete .ini, each key with its meaning above it.");
    return [markdown]
    {
        if (*markdown)
            print_markdown({});
        else
            save_run_config(std::cout, {});
        return int{kExitOk};
    };
}
}  // namespace rtob

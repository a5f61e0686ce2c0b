// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_options.h"

#include <rtob/core/option_checks.h>
#include <rtob/map/options_io.h>

#include "usage_error.h"

namespace rtob
{
namespace
{
std::vector<std::string> section_names()
{
    std::vector<std::string> names;
    const RunConfig config;
    RunConfig::sections(config, [&](const char* name, const auto&) { names.emplace_back(name); });
    return names;
}

void load_file(const std::string& file, RunConfig& config)
{
    const auto ini = open_config(file);
    check_sections(ini, section_names());
    RunConfig::sections(
        config,
        [&](const char* name, auto& options)
        {
            if (ini.sectionExists(name)) load_options(ini, name, options);
        });
}

void apply_flag(const OptionFlag& flag, RunConfig& config)
{
    bool is_known = false;
    try
    {
        RunConfig::sections(
            config,
            [&](const char* name, auto& options)
            {
                if (flag.section != name) return;
                is_known = true;
                set_option(options, flag.key, flag.value);
            });
    }
    catch (const std::invalid_argument& error)
    {
        throw UsageError(flag.typed + ": " + error.what());
    }
    if (!is_known)
        throw UsageError(
            flag.typed + ": unknown section '" + flag.section + "'" +
            suggestion(flag.section, section_names()));
}

void validate_flags(const RunConfig& config)
{
    RunConfig::sections(
        config,
        [](const char* name, const auto& options)
        {
            try
            {
                options.validate();
            }
            catch (const std::invalid_argument& error)
            {
                throw UsageError(
                    "the flags for section [" + std::string(name) + "]: " + error.what());
            }
        });
}
}  // namespace

void RunOptions::validate() const
{
    require(
        map_resolution_m >= 0.005 && map_resolution_m <= 100, "map_resolution_m", map_resolution_m,
        "0.005 to 100");
}

OptionFlag parse_set_flag(const std::string& text)
{
    const auto equals = text.find('=');
    const auto dot = text.substr(0, equals).find('.');
    if (equals == std::string::npos || dot == std::string::npos)
        throw UsageError("--set " + text + ": write --set Section.key=value");
    return {
        "--set " + text, text.substr(0, dot), text.substr(dot + 1, equals - dot - 1),
        text.substr(equals + 1)};
}

std::vector<OptionFlag> parse_set_flags(const std::vector<std::string>& texts)
{
    std::vector<OptionFlag> flags;
    for (const auto& text : texts) flags.push_back(parse_set_flag(text));
    return flags;
}

RunConfig load_run_config(const std::string& file, const std::vector<OptionFlag>& flags)
{
    RunConfig config;
    if (!file.empty()) load_file(file, config);
    for (const auto& flag : flags) apply_flag(flag, config);
    validate_flags(config);
    config.slam.seed = config.run.seed;
    return config;
}

void save_run_config(std::ostream& out, const RunConfig& config)
{
    bool is_first = true;
    RunConfig::sections(
        config,
        [&](const char* section, const auto& options)
        {
            if (!is_first) out << "\n";
            is_first = false;
            save_options(out, section, options);
        });
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/config/CConfigFile.h>

#include <string>
#include <vector>

/// MRPT's reader takes a missing file for an empty one and skips lines it does not understand.
/// These functions refuse both, so that a typo is never a silent default.
namespace rtob
{
/// Opens an existing configuration file. Throws std::runtime_error that names file and line when it
/// cannot be read, a line is no section, `key = value` or comment, or a key stands twice in a
/// section.
[[nodiscard]] mrpt::config::CConfigFile open_config(const std::string& file);

/// Throws std::runtime_error for a section that is not among the known ones (exact spelling).
void check_sections(
    const mrpt::config::CConfigFileBase& config, const std::vector<std::string>& known);

/// The file behind a configuration as error messages name it.
[[nodiscard]] std::string config_name(const mrpt::config::CConfigFileBase& config);

/// The keys of a section as the file spells them, without its comments.
[[nodiscard]] std::vector<std::string> config_keys(
    const mrpt::config::CConfigFileBase& config, const std::string& section);

/// The text of a value without trailing `// ...`, `# ...` or `; ...` and without outer blanks.
[[nodiscard]] std::string config_value(
    const mrpt::config::CConfigFileBase& config, const std::string& section,
    const std::string& key);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace rtob
{
/// Runs a program to its end, with empty input; all that it prints goes into a file.
/// @return why it failed: the message after the last "rtob-slam: " it printed, or how it ended;
/// empty when it succeeded. Throws std::runtime_error when it cannot be started.
[[nodiscard]] std::string run_child(
    const std::string& program, const std::vector<std::string>& arguments,
    const std::string& console_file);

/// Lets the running program end together with the one that started it: a comparison that is killed
/// leaves no runs behind.
void end_with_parent();

/// The file of the program that is running.
[[nodiscard]] std::string own_program();
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rtob
{
/// What this computer and these programs are, name and value: what times can be compared with.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> machine_facts();

/// Programs that ran in the last minute, and processors.
struct MachineLoad
{
    double programs = 0;
    unsigned processors = 1;
};

[[nodiscard]] std::optional<MachineLoad> machine_load();

/// What to think of times that were taken on a computer this busy; empty where nothing.
[[nodiscard]] std::string remark_on(const MachineLoad& load);
}  // namespace rtob

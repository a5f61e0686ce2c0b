// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace rtob
{
/// What this computer and these programs are, name and value: what times can be compared with.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> machine_facts();
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/eval/comparison.h>

#include <functional>
#include <string>
#include <vector>

#include "compare/variant_list.h"

namespace rtob
{
/// What `rtob-slam compare` is asked to do with one log.
struct CompareJob
{
    std::string log, folder;
    std::string truth;  ///< empty: none
    bool may_overwrite = false;
    std::string config_file;
    std::vector<std::string> sets;
    RunLimits limits;
    VariantChoice choice;
    int repeats = 3, seeds = 3;
    double time_limit_s = 0;  ///< of a run; 0: none
    std::string command;      ///< that the user typed
};

/// Runs all variants, each run in a process of its own, and writes the folder with the report. A
/// run that fails has its reason in the result. Throws std::runtime_error, and leaves no folder,
/// for a log or a truth that cannot be used.
[[nodiscard]] Comparison do_compare(
    const CompareJob& job, const std::function<void(const std::string&)>& say);
}  // namespace rtob

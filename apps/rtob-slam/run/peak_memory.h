// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/resource.h>

namespace rtob
{
/// The most memory [MB] that this process has held so far.
[[nodiscard]] inline double peak_memory_mb()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
}
}  // namespace rtob

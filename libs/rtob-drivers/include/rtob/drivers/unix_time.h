// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>

namespace rtob
{
/// Now, in the seconds that stamps of logs are in.
[[nodiscard]] inline double unix_time_s()
{
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/core/Clock.h>

#include <cstdint>

namespace rtob
{
/// MRPT counts 100 ns since 1601; its fromDouble() would round to the step of a double, which
/// depends on the version's arithmetic.
constexpr std::int64_t ticks_1601_to_1970 = 116'444'736'000'000'000;

[[nodiscard]] inline mrpt::Clock::time_point clock_of(std::int64_t unix_100ns)
{
    return mrpt::Clock::time_point(mrpt::Clock::duration(unix_100ns + ticks_1601_to_1970));
}

[[nodiscard]] inline std::int64_t unix_100ns_of(mrpt::Clock::time_point stamp)
{
    return stamp.time_since_epoch().count() - ticks_1601_to_1970;
}
}  // namespace rtob

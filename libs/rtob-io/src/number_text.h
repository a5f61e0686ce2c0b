// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <ostream>

namespace rtob
{
/// Numbers as text, the same in any locale.
void write_fixed(std::ostream& out, double value, int decimals);

/// The shortest text that reads back as the same number.
void write_exact(std::ostream& out, double value);
void write_exact(std::ostream& out, float value);
void write_exact(std::ostream& out, std::int64_t value);

/// Seconds of a time in units of 100 ns, exactly: six decimals, seven where needed.
void write_ticks_100ns(std::ostream& out, std::int64_t ticks);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <random>

namespace rtob
{
/// The one source of chance: same seed, same numbers, with every compiler and library. The
/// generator's sequence is fixed by the C++ standard; the standard's distributions are not, so the
/// mappings are ours.
class Random
{
 public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// In [0, 1), 53 bits.
    [[nodiscard]] double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

    /// In [0, n); 0 for n = 0. The bias is below n / 2^53.
    [[nodiscard]] std::uint64_t below(std::uint64_t n)
    {
        return static_cast<std::uint64_t>(uniform() * static_cast<double>(n));
    }

 private:
    std::mt19937_64 engine_;
};
}  // namespace rtob

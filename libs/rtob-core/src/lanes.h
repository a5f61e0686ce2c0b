// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/simd.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace rtob
{
constexpr std::size_t kLanes = 8;  ///< numbers worked on together, on every processor

using FloatLanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using IndexLanes = std::int32_t __attribute__((vector_size(kLanes * sizeof(std::int32_t))));

// By reference: lanes that are returned would need one way of passing them on all processors.
RTOB_INLINE void load(const float* from, FloatLanes& lanes)
{
    std::memcpy(&lanes, from, sizeof lanes);
}

RTOB_INLINE void store(const FloatLanes& lanes, float* to)
{
    std::memcpy(to, &lanes, sizeof lanes);
}

/// begin, begin + 1, ...
RTOB_INLINE void count_up(std::uint32_t begin, IndexLanes& lanes)
{
    lanes = IndexLanes{0, 1, 2, 3, 4, 5, 6, 7} + static_cast<std::int32_t>(begin);
}

template <class Half, class Lanes>
RTOB_INLINE auto smallest_of(const Lanes& lanes)
{
    Half low, high;
    std::memcpy(&low, &lanes, sizeof low);
    std::memcpy(&high, reinterpret_cast<const char*>(&lanes) + sizeof low, sizeof high);
    const Half m = low < high ? low : high;
    const auto a = m[0] < m[1] ? m[0] : m[1], b = m[2] < m[3] ? m[2] : m[3];
    return a < b ? a : b;
}
RTOB_INLINE float smallest(const FloatLanes& lanes)
{
    return smallest_of<float __attribute__((vector_size(sizeof(FloatLanes) / 2)))>(lanes);
}
RTOB_INLINE std::int32_t smallest(const IndexLanes& lanes)
{
    return smallest_of<std::int32_t __attribute__((vector_size(sizeof(IndexLanes) / 2)))>(lanes);
}

/// In a fixed order.
RTOB_INLINE float sum_of(const FloatLanes& lanes)
{
    return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
           ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/gaussian_sum.h>
#include <rtob/core/simd.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace rtob
{
namespace
{
constexpr std::size_t kLanes = 8;  // the sum's order is fixed by this, not by the processor

/// exp(-y) for y in [0, 8]: exp(-y / 16) by its series, to the 16th power by squaring.
inline float exp_minus(float y)
{
    const float v = y * (1.0f / 16.0f);
    float e = 1.0f -
              v * (1.0f -
                   v * (1.0f / 2) *
                       (1.0f - v * (1.0f / 3) *
                                   (1.0f - v * (1.0f / 4) *
                                               (1.0f - v * (1.0f / 5) * (1.0f - v * (1.0f / 6))))));
    e *= e;
    e *= e;
    e *= e;
    return e * e;
}

RTOB_SIMD_CLONES void add_lanes(
    const double* time_s, const double* x, const double* y, std::size_t blocks, double now_s,
    double scale, const Box& near, std::array<float, kLanes>& sums)
{
    for (std::size_t block = 0; block < blocks; ++block)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
        {
            const std::size_t i = block * kLanes + lane;
            const float z = static_cast<float>((time_s[i] - now_s) * scale);
            const bool inside = (x[i] >= near.min_x) & (x[i] <= near.max_x) & (y[i] >= near.min_y) &
                                (y[i] <= near.max_y);
            sums[lane] += inside ? exp_minus(z * z) : 0.0f;
        }
}
}  // namespace

double gaussian_sum(
    const ScanTable& table, const ScanRange& range, double time_s, double sigma_s, const Box& near)
{
    const double scale = 1 / (std::sqrt(2.0) * sigma_s);
    std::array<float, kLanes> sums{};
    const std::size_t blocks = (range.end - range.first) / kLanes;
    const std::size_t tail = range.first + blocks * kLanes;
    add_lanes(
        table.times() + range.first, table.xs() + range.first, table.ys() + range.first, blocks,
        time_s, scale, near, sums);
    double sum = 0;
    for (const float s : sums) sum += s;
    for (std::size_t i = tail; i < range.end; ++i)
        if (near.contains(table.x(i), table.y(i)))
        {
            const float z = static_cast<float>((table.time(i) - time_s) * scale);
            sum += exp_minus(z * z);
        }
    return sum;
}
}  // namespace rtob

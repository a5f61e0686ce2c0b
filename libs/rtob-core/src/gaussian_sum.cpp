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
    double scale, Box near, float* sums)
{
    float lanes[kLanes] = {};
    for (std::size_t block = 0; block < blocks; ++block, time_s += kLanes, x += kLanes, y += kLanes)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
        {
            const auto z = static_cast<float>((time_s[lane] - now_s) * scale);
            // Factors instead of a branch: so that the lanes run side by side.
            const float in_x =
                (x[lane] >= near.min_x ? 1.0f : 0.0f) * (x[lane] <= near.max_x ? 1.0f : 0.0f);
            const float in_y =
                (y[lane] >= near.min_y ? 1.0f : 0.0f) * (y[lane] <= near.max_y ? 1.0f : 0.0f);
            lanes[lane] += exp_minus(z * z) * (in_x * in_y);
        }
    for (std::size_t lane = 0; lane < kLanes; ++lane) sums[lane] = lanes[lane];
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
        time_s, scale, near, sums.data());
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

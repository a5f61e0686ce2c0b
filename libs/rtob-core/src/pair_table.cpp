// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/pair_table.h>
#include <rtob/core/simd.h>
#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr std::size_t kLanes = 8;  // the sums' order is fixed by this, not by the processor

/// What a sum over pairs reads; blocks of kLanes.
struct Columns
{
    const float *x, *y, *u, *v, *nx, *ny, *d2;
    std::size_t blocks;
};

RTOB_SIMD_CLONES void line_residuals(const Columns& c, float* squared_residual)
{
    for (std::size_t i = 0; i < c.blocks * kLanes; ++i)
    {
        const float across = c.nx[i] * (c.x[i] - c.u[i]) + c.ny[i] * (c.y[i] - c.v[i]);
        const float on_line = c.nx[i] * c.nx[i] + c.ny[i] * c.ny[i];
        squared_residual[i] = on_line > 0 ? across * across : c.d2[i];
    }
}

/// Replaces squared residuals by weights; branches become selections, so that lanes run side by
/// side.
RTOB_SIMD_CLONES void kernel_weights(
    RobustKernel kernel, float per_scale2, std::size_t blocks, float* w)
{
    const std::size_t n = blocks * kLanes;
    switch (kernel)
    {
        case RobustKernel::None:
            for (std::size_t i = 0; i < n; ++i) w[i] = 1;
            break;
        case RobustKernel::Huber:
            for (std::size_t i = 0; i < n; ++i)
                w[i] = 1 / std::sqrt(std::max(1.0f, w[i] * per_scale2));
            break;
        case RobustKernel::Cauchy:
            for (std::size_t i = 0; i < n; ++i) w[i] = 1 / (1 + w[i] * per_scale2);
            break;
        case RobustKernel::Tukey:
            for (std::size_t i = 0; i < n; ++i)
            {
                const float left = std::max(0.0f, 1 - w[i] * per_scale2);
                w[i] = left * left;
            }
            break;
    }
}

enum MotionSum
{
    kW,
    kX,
    kY,
    kU,
    kV,
    kCos,
    kSin,
    kMotionSums
};

RTOB_SIMD_CLONES void add_motion_lanes(
    const Columns& c, const float* weight, float origin_x, float origin_y, float* sums)
{
    float lanes[kMotionSums][kLanes] = {};
    for (std::size_t i = 0; i < c.blocks * kLanes; i += kLanes)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
        {
            const std::size_t k = i + lane;
            const float w = weight[k];
            const float x = c.x[k] - origin_x, y = c.y[k] - origin_y;
            const float u = c.u[k] - origin_x, v = c.v[k] - origin_y;
            lanes[kW][lane] += w;
            lanes[kX][lane] += w * x;
            lanes[kY][lane] += w * y;
            lanes[kU][lane] += w * (u - x);
            lanes[kV][lane] += w * (v - y);
            lanes[kCos][lane] += w * (x * u + y * v);
            lanes[kSin][lane] += w * (x * (v - y) - y * (u - x));
        }
    for (int s = 0; s < kMotionSums; ++s)
        for (std::size_t lane = 0; lane < kLanes; ++lane) sums[s] += lanes[s][lane];
}

enum NormalSum
{
    kH00,
    kH01,
    kH11,
    kH02,
    kH12,
    kH22,
    kG0,
    kG1,
    kG2,
    kNormalSums
};

RTOB_SIMD_CLONES void add_normal_lanes(
    const Columns& c, const float* weight, float center_x, float center_y, float along_line,
    float* sums)
{
    float lanes[kNormalSums][kLanes] = {};
    for (std::size_t i = 0; i < c.blocks * kLanes; i += kLanes)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
        {
            const std::size_t k = i + lane;
            const float w = weight[k], nx = c.nx[k], ny = c.ny[k];
            // The metric: 1 across the line, along_line along it; 1 both ways on no line.
            const float on_line = nx * nx + ny * ny > 0 ? 1.0f : 0.0f;
            const float isotropic = w * (on_line * along_line + (1 - on_line));
            const float across = w * (1 - along_line);
            const float mxx = across * nx * nx + isotropic;
            const float mxy = across * nx * ny;
            const float myy = across * ny * ny + isotropic;
            // Yaw turns about the center.
            const float jx = center_y - c.y[k], jy = c.x[k] - center_x;
            const float ex = c.x[k] - c.u[k], ey = c.y[k] - c.v[k];
            const float ax = mxx * jx + mxy * jy, ay = mxy * jx + myy * jy;
            lanes[kH00][lane] += mxx;
            lanes[kH01][lane] += mxy;
            lanes[kH11][lane] += myy;
            lanes[kH02][lane] += ax;
            lanes[kH12][lane] += ay;
            lanes[kH22][lane] += jx * ax + jy * ay;
            lanes[kG0][lane] += mxx * ex + mxy * ey;
            lanes[kG1][lane] += mxy * ex + myy * ey;
            lanes[kG2][lane] += ax * ex + ay * ey;
        }
    for (int s = 0; s < kNormalSums; ++s)
        for (std::size_t lane = 0; lane < kLanes; ++lane) sums[s] += lanes[s][lane];
}
}  // namespace

void PairTable::clear()
{
    size_ = 0;
}

void PairTable::reserve(std::size_t pairs)
{
    const std::size_t padded = (pairs + kLanes - 1) / kLanes * kLanes;
    if (x_.size() >= padded) return;
    scan_point_.resize(padded);
    neighbour_.resize(padded);
    for (auto* column :
         {&x_, &y_, &neighbour_x_, &neighbour_y_, &normal_x_, &normal_y_, &squared_distance_,
          &weight_})
        column->resize(padded);
}

void PairTable::add(const Pair& pair)
{
    const std::size_t i = size_++;
    scan_point_[i] = pair.scan_point;
    neighbour_[i] = pair.neighbour;
    x_[i] = pair.x;
    y_[i] = pair.y;
    neighbour_x_[i] = pair.neighbour_x;
    neighbour_y_[i] = pair.neighbour_y;
    normal_x_[i] = pair.normal_x;
    normal_y_[i] = pair.normal_y;
    squared_distance_[i] = pair.squared_distance;
}

PairTable::Pair PairTable::at(std::size_t i) const
{
    return {scan_point_[i], neighbour_[i],   x_[i],
            y_[i],          neighbour_x_[i], neighbour_y_[i],
            normal_x_[i],   normal_y_[i],    squared_distance_[i]};
}

std::size_t PairTable::blocks() const
{
    return (size_ + kLanes - 1) / kLanes;
}

void PairTable::weigh(RobustKernel kernel, double scale_m, bool to_line)
{
    if (to_line)
        line_residuals(
            {x_.data(), y_.data(), neighbour_x_.data(), neighbour_y_.data(), normal_x_.data(),
             normal_y_.data(), squared_distance_.data(), blocks()},
            weight_.data());
    else
        std::copy_n(squared_distance_.begin(), size_, weight_.begin());
    kernel_weights(kernel, static_cast<float>(1 / (scale_m * scale_m)), blocks(), weight_.data());
    std::fill_n(weight_.begin() + static_cast<std::ptrdiff_t>(size_), blocks() * kLanes - size_, 0);
}

Pose2 PairTable::rigidMotion() const
{
    if (size_ == 0) return {};
    // Seen from the first point the numbers stay small, and so does what rounding takes.
    const float origin_x = x_[0], origin_y = y_[0];
    std::array<float, kMotionSums> lanes{};
    add_motion_lanes(
        {x_.data(), y_.data(), neighbour_x_.data(), neighbour_y_.data(), nullptr, nullptr, nullptr,
         blocks()},
        weight_.data(), origin_x, origin_y, lanes.data());
    std::array<double, kMotionSums> sum{};
    std::copy(lanes.begin(), lanes.end(), sum.begin());
    if (sum[kW] <= 0) return {};
    const double mean_x = sum[kX] / sum[kW], mean_y = sum[kY] / sum[kW];
    const double du = sum[kU] / sum[kW], dv = sum[kV] / sum[kW];
    const double cosine = sum[kCos] - sum[kW] * (mean_x * (mean_x + du) + mean_y * (mean_y + dv));
    const double sine = sum[kSin] - sum[kW] * (mean_x * dv - mean_y * du);
    if (cosine == 0 && sine == 0) return {};
    const double yaw = std::atan2(sine, cosine), c = std::cos(yaw), s = std::sin(yaw);
    const double pivot_x = mean_x + origin_x, pivot_y = mean_y + origin_y;
    return {
        pivot_x + du - (c * pivot_x - s * pivot_y), pivot_y + dv - (s * pivot_x + c * pivot_y),
        yaw};
}

PairTable::NormalEquations PairTable::normalEquations(
    double center_x, double center_y, double along_line) const
{
    std::array<float, kNormalSums> sum{};
    add_normal_lanes(
        {x_.data(), y_.data(), neighbour_x_.data(), neighbour_y_.data(), normal_x_.data(),
         normal_y_.data(), nullptr, blocks()},
        weight_.data(), static_cast<float>(center_x), static_cast<float>(center_y),
        static_cast<float>(along_line), sum.data());
    NormalEquations equations;
    equations.h << sum[kH00], sum[kH01], sum[kH02],  //
        sum[kH01], sum[kH11], sum[kH12],             //
        sum[kH02], sum[kH12], sum[kH22];
    equations.g << sum[kG0], sum[kG1], sum[kG2];
    return equations;
}
}  // namespace rtob

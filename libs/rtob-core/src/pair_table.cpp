// SPDX-License-Identifier: BSD-3-Clause
#include "lanes.h"

#include <rtob/core/pair_table.h>
#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
RTOB_INLINE void load_points(
    const PairColumns& c, std::size_t i, FloatLanes& x, FloatLanes& y, FloatLanes& u, FloatLanes& v)
{
    load(c.x + i, x);
    load(c.y + i, y);
    load(c.u + i, u);
    load(c.v + i, v);
}

RTOB_INLINE void load_normals(const PairColumns& c, std::size_t i, FloatLanes& nx, FloatLanes& ny)
{
    load(c.nx + i, nx);
    load(c.ny + i, ny);
}

RTOB_SIMD_CLONES void square_distances(const PairColumns& c, float* squared_distance)
{
    for (std::size_t i = 0; i < c.blocks * kLanes; ++i)
    {
        const float dx = c.u[i] - c.x[i], dy = c.v[i] - c.y[i];
        squared_distance[i] = dx * dx + dy * dy;
    }
}

RTOB_SIMD_CLONES void drop_beyond(const PairColumns& c, float limit2, float* weight)
{
    for (std::size_t i = 0; i < c.blocks * kLanes; ++i)
        weight[i] = c.d2[i] <= limit2 ? weight[i] : 0;
}

RTOB_SIMD_CLONES void line_residuals(const PairColumns& c, float* squared_residual)
{
    for (std::size_t i = 0; i < c.blocks * kLanes; i += kLanes)
    {
        FloatLanes x, y, u, v, nx, ny, d2;
        load_points(c, i, x, y, u, v);
        load_normals(c, i, nx, ny);
        load(c.d2 + i, d2);
        const FloatLanes across = nx * (x - u) + ny * (y - v);
        store(nx * nx + ny * ny > 0 ? across * across : d2, squared_residual + i);
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
    const PairColumns& c, const float* weight, float origin_x, float origin_y, float* sums)
{
    FloatLanes lanes[kMotionSums] = {};
    for (std::size_t i = 0; i < c.blocks * kLanes; i += kLanes)
    {
        FloatLanes w, x, y, u, v;
        load(weight + i, w);
        load_points(c, i, x, y, u, v);
        x -= origin_x;
        y -= origin_y;
        u -= origin_x;
        v -= origin_y;
        lanes[kW] += w;
        lanes[kX] += w * x;
        lanes[kY] += w * y;
        lanes[kU] += w * (u - x);
        lanes[kV] += w * (v - y);
        lanes[kCos] += w * (x * u + y * v);
        lanes[kSin] += w * (x * (v - y) - y * (u - x));
    }
    for (int s = 0; s < kMotionSums; ++s) sums[s] = sum_of(lanes[s]);
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
    const PairColumns& c, const float* weight, float center_x, float center_y, float along_line,
    float* sums)
{
    const FloatLanes one = FloatLanes{} + 1.0f, along = FloatLanes{} + along_line;
    FloatLanes lanes[kNormalSums] = {};
    for (std::size_t i = 0; i < c.blocks * kLanes; i += kLanes)
    {
        FloatLanes w, x, y, u, v, nx, ny;
        load(weight + i, w);
        load_points(c, i, x, y, u, v);
        load_normals(c, i, nx, ny);
        // The metric: 1 across the line, along_line along it; 1 both ways on no line.
        const FloatLanes isotropic = w * (nx * nx + ny * ny > 0 ? along : one);
        const FloatLanes across = w * (1 - along_line);
        const FloatLanes mxx = across * nx * nx + isotropic;
        const FloatLanes mxy = across * nx * ny;
        const FloatLanes myy = across * ny * ny + isotropic;
        // Yaw turns about the center.
        const FloatLanes jx = center_y - y, jy = x - center_x;
        const FloatLanes ex = x - u, ey = y - v;
        const FloatLanes ax = mxx * jx + mxy * jy, ay = mxy * jx + myy * jy;
        lanes[kH00] += mxx;
        lanes[kH01] += mxy;
        lanes[kH11] += myy;
        lanes[kH02] += ax;
        lanes[kH12] += ay;
        lanes[kH22] += jx * ax + jy * ay;
        lanes[kG0] += mxx * ex + mxy * ey;
        lanes[kG1] += mxy * ex + myy * ey;
        lanes[kG2] += ax * ex + ay * ey;
    }
    for (int s = 0; s < kNormalSums; ++s) sums[s] = sum_of(lanes[s]);
}
}  // namespace

void PairTable::reserve(std::size_t scan_points)
{
    for (auto* column :
         {&x_, &y_, &normal_x_, &normal_y_, &neighbour_x_, &neighbour_y_, &squared_distance_,
          &weight_})
        column->reserve(scan_points + kLanes);
}

void PairTable::reset(std::size_t scan_points)
{
    size_ = scan_points;
    pairs_ = 0;
    const std::size_t padded = blocks() * kLanes;
    for (auto* column : {&x_, &y_, &normal_x_, &normal_y_}) column->assign(padded, 0);
    for (auto* column : {&neighbour_x_, &neighbour_y_}) column->assign(padded, kAlone.x);
    squared_distance_.resize(padded);
    weight_.resize(padded);
}

void PairTable::move(const PointsView& scan, const Pose2& pose)
{
    const auto c = static_cast<float>(std::cos(pose.yaw));
    const auto s = static_cast<float>(std::sin(pose.yaw));
    const auto tx = static_cast<float>(pose.x), ty = static_cast<float>(pose.y);
    for (std::size_t i = 0; i < size_; ++i)
    {
        x_[i] = c * scan.x[i] - s * scan.y[i] + tx;
        y_[i] = s * scan.x[i] + c * scan.y[i] + ty;
    }
}

std::size_t PairTable::blocks() const
{
    return (size_ + kLanes - 1) / kLanes;
}

PairColumns PairTable::columns() const
{
    return {x_.data(),        y_.data(),        neighbour_x_.data(),      neighbour_y_.data(),
            normal_x_.data(), normal_y_.data(), squared_distance_.data(), blocks()};
}

void PairTable::measure(double max_distance_m)
{
    const auto limit_m = static_cast<float>(max_distance_m);
    limit2_ = limit_m * limit_m;
    square_distances(columns(), squared_distance_.data());
    pairs_ = static_cast<std::size_t>(std::count_if(
        squared_distance_.begin(), squared_distance_.begin() + static_cast<std::ptrdiff_t>(size_),
        [this](float d2) { return d2 <= limit2_; }));
}

void PairTable::weigh(RobustKernel kernel, double scale_m, bool to_line)
{
    if (to_line)
        line_residuals(columns(), weight_.data());
    else
        std::copy(squared_distance_.begin(), squared_distance_.end(), weight_.begin());
    kernel_weights(kernel, static_cast<float>(1 / (scale_m * scale_m)), blocks(), weight_.data());
    drop_beyond(columns(), limit2_, weight_.data());
}

Pose2 PairTable::rigidMotion() const
{
    if (size_ == 0) return {};
    // Seen from the first point the numbers stay small, and so does what rounding takes.
    const float origin_x = x_[0], origin_y = y_[0];
    std::array<float, kMotionSums> lanes{};
    add_motion_lanes(columns(), weight_.data(), origin_x, origin_y, lanes.data());
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
        columns(), weight_.data(), static_cast<float>(center_x), static_cast<float>(center_y),
        static_cast<float>(along_line), sum.data());
    NormalEquations equations;
    equations.h << sum[kH00], sum[kH01], sum[kH02],  //
        sum[kH01], sum[kH11], sum[kH12],             //
        sum[kH02], sum[kH12], sum[kH22];
    equations.g << sum[kG0], sum[kG1], sum[kG2];
    return equations;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/icp.h>
#include <rtob/core/option_checks.h>
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr std::size_t kMinPairs = 3;
// Ground is known where the reference has a point within this many pair distances.
constexpr double kKnownReach = 3;
// A pair that lies on no line constrains both directions; one on a line, this little along it.
constexpr double kAlongLine = 0.02;
// Range noise and the points' own spread: no covariance is better than this allows.
constexpr double kMinVariance = 0.01 * 0.01;
}  // namespace

void IcpOptions::validate() const
{
    require(iterations >= 1, "iterations", iterations, ">= 1");
    require(max_pair_distance_m > 0, "max_pair_distance_m", max_pair_distance_m, "> 0");
    require(
        final_pair_distance_m > 0 && final_pair_distance_m <= max_pair_distance_m,
        "final_pair_distance_m", final_pair_distance_m, "> 0 and at most max_pair_distance_m");
    require(kernel_scale_m > 0, "kernel_scale_m", kernel_scale_m, "> 0");
    require(
        line_radius_m > 0 && line_radius_m <= max_pair_distance_m, "line_radius_m", line_radius_m,
        "> 0 and at most max_pair_distance_m");
    require(cell_points >= 0, "cell_points", cell_points, ">= 0");
    require(stop_step_m >= 0, "stop_step_m", stop_step_m, ">= 0");
}

Pose2 apply_correction(const Pose2& pose_map_vehicle_init, const Pose2& correction)
{
    return {
        pose_map_vehicle_init.x + correction.x, pose_map_vehicle_init.y + correction.y,
        wrap_angle(pose_map_vehicle_init.yaw + correction.yaw)};
}

Icp::Icp(const IcpOptions& options) : options_(options)
{
    options_.validate();
}

IcpResult Icp::align(
    const PointsView& scan, const PointsView& reference, const CorrectionPrior& prior)
{
    IcpResult result;
    grid_.build(
        reference, options_.max_pair_distance_m, static_cast<std::uint32_t>(options_.cell_points));
    lines_.reset(grid_, options_.line_radius_m);
    last_.assign(scan.size, NeighbourGrid::kNone);
    const bool closed_form =
        options_.metric == IcpMetric::PointToPoint && prior.information.isZero(0);
    const int final_phase = (options_.iterations + 1) / 2;  // from here the pair distance is final
    for (int phase = 0; phase < options_.iterations; ++phase)
    {
        const double distance_m = pairDistance(phase);
        scale_m_ = options_.kernel_scale_m * distance_m / options_.final_pair_distance_m;
        findPairs(scan, result.correction, distance_m);
        if (pairs_.size() < kMinPairs) break;
        const Pose2 before = result.correction;
        result.correction =
            closed_form ? fitClosedForm(scan, before) : fitLinearised(before, prior);
        ++result.iterations;
        if (!isAtRest(before, result.correction)) continue;
        if (phase >= final_phase) break;
        phase = final_phase - 1;
    }
    findPairs(scan, result.correction, options_.final_pair_distance_m);
    describe(scan, result);
    return result;
}

bool Icp::isAtRest(const Pose2& before, const Pose2& now) const
{
    // 1 m: where the turn's share of the step is measured.
    return std::hypot(now.x - before.x, now.y - before.y) + std::abs(now.yaw - before.yaw) <
           options_.stop_step_m;
}

/// Shrinks from the largest to the final distance over the first half of the iterations.
double Icp::pairDistance(int iteration) const
{
    const double progress = 2.0 * iteration / options_.iterations;
    if (progress >= 1) return options_.final_pair_distance_m;
    return options_.max_pair_distance_m *
           std::pow(options_.final_pair_distance_m / options_.max_pair_distance_m, progress);
}

void Icp::findPairs(const PointsView& scan, const Pose2& correction, double max_distance_m)
{
    const auto c = static_cast<float>(std::cos(correction.yaw));
    const auto s = static_cast<float>(std::sin(correction.yaw));
    const auto tx = static_cast<float>(correction.x), ty = static_cast<float>(correction.y);
    const auto limit = static_cast<float>(max_distance_m);
    moved_.x.resize(scan.size);
    moved_.y.resize(scan.size);
    pairs_.clear();
    pairs_.reserve(scan.size);
    const Points& reference = grid_.points();
    for (std::size_t i = 0; i < scan.size; ++i)
    {
        const float x = moved_.x[i] = c * scan.x[i] - s * scan.y[i] + tx;
        const float y = moved_.y[i] = s * scan.x[i] + c * scan.y[i] + ty;
        // The last neighbour bounds the search: once the scan rests, few cells are looked at.
        float radius = limit;
        if (last_[i] != NeighbourGrid::kNone)
        {
            const auto j = static_cast<std::size_t>(last_[i]);
            const float dx = reference.x[j] - x, dy = reference.y[j] - y;
            // A little more than the distance, so that rounding cannot lose the last neighbour.
            radius = std::min(limit, std::sqrt(dx * dx + dy * dy) * 1.00001f);
        }
        const auto neighbour = grid_.nearest(x, y, radius);
        if (neighbour.index == NeighbourGrid::kNone) continue;
        last_[i] = neighbour.index;
        pairs_.push_back({i, neighbour.index, neighbour.squared_distance});
    }
}

double Icp::weight(double squared_residual) const
{
    const double ratio2 = squared_residual / (scale_m_ * scale_m_);
    switch (options_.kernel)
    {
        case RobustKernel::None:
            return 1;
        case RobustKernel::Huber:
            return ratio2 <= 1 ? 1 : 1 / std::sqrt(ratio2);
        case RobustKernel::Cauchy:
            return 1 / (1 + ratio2);
        case RobustKernel::Tukey:
            return ratio2 <= 1 ? (1 - ratio2) * (1 - ratio2) : 0;
    }
    return 1;
}

/// The least-squares rigid motion from the scan to its neighbours, in closed form (2-D Umeyama).
Pose2 Icp::fitClosedForm(const PointsView& scan, const Pose2& correction) const
{
    const Points& reference = grid_.points();
    double sw = 0, sx = 0, sy = 0, su = 0, sv = 0, sxu = 0, syv = 0, sxv = 0, syu = 0;
    for (const Pair& pair : pairs_)
    {
        const auto j = static_cast<std::size_t>(pair.neighbour);
        const double w = weight(pair.squared_distance);
        const double x = scan.x[pair.scan_point], y = scan.y[pair.scan_point];
        const double u = reference.x[j], v = reference.y[j];
        sw += w;
        sx += w * x;
        sy += w * y;
        su += w * u;
        sv += w * v;
        sxu += w * x * u;
        syv += w * y * v;
        sxv += w * x * v;
        syu += w * y * u;
    }
    if (sw <= 0) return correction;
    const double cosine = sxu + syv - (sx * su + sy * sv) / sw;
    const double sine = sxv - syu - (sx * sv - sy * su) / sw;
    if (cosine == 0 && sine == 0) return correction;
    const double yaw = std::atan2(sine, cosine), c = std::cos(yaw), s = std::sin(yaw);
    return {(su - (c * sx - s * sy)) / sw, (sv - (s * sx + c * sy)) / sw, yaw};
}

/// One Gauss-Newton step: pairs pull across their line, or both ways where there is none.
Pose2 Icp::fitLinearised(const Pose2& correction, const CorrectionPrior& prior)
{
    const Points& reference = grid_.points();
    Eigen::Matrix3d h = prior.information;
    Eigen::Vector3d g =
        prior.information * Eigen::Vector3d(correction.x, correction.y, correction.yaw);
    for (const Pair& pair : pairs_)
    {
        const auto j = static_cast<std::size_t>(pair.neighbour);
        const double x = moved_.x[pair.scan_point], y = moved_.y[pair.scan_point];
        const double ex = x - reference.x[j], ey = y - reference.y[j];
        double mxx = 1, mxy = 0, myy = 1;
        double residual2 = pair.squared_distance;
        if (options_.metric == IcpMetric::PointToLine)
        {
            const LineField::Line& line = lines_.at(pair.neighbour);
            if (line.normal_x != 0 || line.normal_y != 0)
            {
                const double nx = line.normal_x, ny = line.normal_y;
                mxx = nx * nx + kAlongLine * ny * ny;
                mxy = nx * ny * (1 - kAlongLine);
                myy = ny * ny + kAlongLine * nx * nx;
                const double across = nx * ex + ny * ey;
                residual2 = across * across;
            }
        }
        const double w = weight(residual2);
        // Yaw turns about the vehicle, which the correction has moved.
        const double jx = -(y - correction.y), jy = x - correction.x;
        const double ax = mxx * jx + mxy * jy, ay = mxy * jx + myy * jy;
        const double bx = mxx * ex + mxy * ey, by = mxy * ex + myy * ey;
        h(0, 0) += w * mxx;
        h(0, 1) += w * mxy;
        h(1, 1) += w * myy;
        h(0, 2) += w * ax;
        h(1, 2) += w * ay;
        h(2, 2) += w * (jx * ax + jy * ay);
        g(0) += w * bx;
        g(1) += w * by;
        g(2) += w * (jx * bx + jy * by);
    }
    h(1, 0) = h(0, 1);
    h(2, 0) = h(0, 2);
    h(2, 1) = h(1, 2);
    const Eigen::Vector3d step = h.ldlt().solve(-g);
    if (!step.allFinite()) return correction;
    return {correction.x + step(0), correction.y + step(1), correction.yaw + step(2)};
}

/// How many of the scan's points lie where the reference has something near, paired or not.
std::size_t Icp::countKnown() const
{
    const auto reach = static_cast<float>(kKnownReach * options_.max_pair_distance_m);
    std::size_t known = pairs_.size(), next_pair = 0;
    for (std::size_t i = 0; i < moved_.size(); ++i)
    {
        if (next_pair < pairs_.size() && pairs_[next_pair].scan_point == i)
            ++next_pair;
        else if (grid_.nearest(moved_.x[i], moved_.y[i], reach).index != NeighbourGrid::kNone)
            ++known;
    }
    return known;
}

/// Error, share and covariance of the final pairs. The information counts each pair across its
/// local line only, because along a wall a neighbour is always near: so a corridor shows as long.
void Icp::describe(const PointsView& scan, IcpResult& result)
{
    result.pairs = pairs_.size();
    result.paired_share =
        scan.size == 0 ? 0 : static_cast<double>(pairs_.size()) / static_cast<double>(scan.size);
    if (pairs_.empty()) return;
    result.known_share = static_cast<double>(pairs_.size()) / static_cast<double>(countKnown());
    Eigen::Matrix3d& h = result.information;
    double sum = 0;
    for (const Pair& pair : pairs_)
    {
        sum += pair.squared_distance;
        const LineField::Line& line = lines_.at(pair.neighbour);
        const double jx = -(moved_.y[pair.scan_point] - result.correction.y);
        const double jy = moved_.x[pair.scan_point] - result.correction.x;
        const Eigen::Vector3d across(
            line.normal_x, line.normal_y, line.normal_x * jx + line.normal_y * jy);
        h += across * across.transpose();
    }
    result.mean_squared_error = sum / static_cast<double>(pairs_.size());
    const double variance = std::max(kMinVariance, result.mean_squared_error);
    // 1e-6: so that a direction without any information comes back as very uncertain, not as NaN.
    result.covariance = variance * (h + 1e-6 * Eigen::Matrix3d::Identity()).inverse();
}
}  // namespace rtob

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
    const int final_phase = (options_.iterations + 1) / 2;  // from here the pair distance is final
    for (int phase = 0; phase < options_.iterations; ++phase)
    {
        const double distance_m = pairDistance(phase);
        move(scan, result.correction);
        findPairs(distance_m);
        if (pairs_.size() < kMinPairs) break;
        pairs_.weigh(
            options_.kernel, options_.kernel_scale_m * distance_m / options_.final_pair_distance_m,
            options_.metric == IcpMetric::PointToLine);
        const Pose2 before = result.correction;
        result.correction = fit(before, prior);
        ++result.iterations;
        if (!isAtRest(before, result.correction)) continue;
        if (phase >= final_phase) break;
        phase = final_phase - 1;
    }
    move(scan, result.correction);
    findPairs(options_.final_pair_distance_m);
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

void Icp::move(const PointsView& scan, const Pose2& correction)
{
    const auto c = static_cast<float>(std::cos(correction.yaw));
    const auto s = static_cast<float>(std::sin(correction.yaw));
    const auto tx = static_cast<float>(correction.x), ty = static_cast<float>(correction.y);
    moved_.x.resize(scan.size);
    moved_.y.resize(scan.size);
    for (std::size_t i = 0; i < scan.size; ++i)
    {
        moved_.x[i] = c * scan.x[i] - s * scan.y[i] + tx;
        moved_.y[i] = s * scan.x[i] + c * scan.y[i] + ty;
    }
}

/// How far to look for a point's neighbour: no farther than its last one, or than that of the beam
/// beside it, so that once the scan rests few cells are looked at.
float Icp::reachOf(std::size_t scan_point, float max_distance_m) const
{
    const std::size_t beside = scan_point > 0 ? scan_point - 1 : 0;
    const std::int32_t known =
        last_[scan_point] != NeighbourGrid::kNone ? last_[scan_point] : last_[beside];
    if (known == NeighbourGrid::kNone) return max_distance_m;
    const auto j = static_cast<std::size_t>(known);
    const float dx = grid_.points().x[j] - moved_.x[scan_point];
    const float dy = grid_.points().y[j] - moved_.y[scan_point];
    // A little more than the distance, so that rounding cannot lose that neighbour.
    return std::min(max_distance_m, std::sqrt(dx * dx + dy * dy) * 1.00001f);
}

void Icp::findPairs(double max_distance_m)
{
    const auto limit_m = static_cast<float>(max_distance_m);
    const bool to_line = options_.metric == IcpMetric::PointToLine;
    const Points& reference = grid_.points();
    pairs_.clear();
    pairs_.reserve(moved_.size());
    for (std::size_t i = 0; i < moved_.size(); ++i)
    {
        const float x = moved_.x[i], y = moved_.y[i];
        const auto neighbour = grid_.nearest(x, y, reachOf(i, limit_m));
        if (neighbour.index == NeighbourGrid::kNone) continue;
        last_[i] = neighbour.index;
        const auto j = static_cast<std::size_t>(neighbour.index);
        const LineField::Line line = to_line ? lines_.at(neighbour.index) : LineField::Line();
        pairs_.add(
            {static_cast<std::uint32_t>(i), neighbour.index, x, y, reference.x[j], reference.y[j],
             line.normal_x, line.normal_y, neighbour.squared_distance});
    }
}

/// Point to point in closed form (2.1.3); anything else by one Gauss-Newton step, in which pairs
/// pull across their line, or both ways where there is none.
Pose2 Icp::fit(const Pose2& correction, const CorrectionPrior& prior) const
{
    if (options_.metric == IcpMetric::PointToPoint && prior.information.isZero(0))
        return compose(pairs_.rigidMotion(), correction);
    const auto [h, g] = pairs_.normalEquations(correction.x, correction.y, kAlongLine);
    const Eigen::Vector3d pull =
        g + prior.information * Eigen::Vector3d(correction.x, correction.y, correction.yaw);
    const Eigen::Vector3d step = (h + prior.information).ldlt().solve(-pull);
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
        if (next_pair < pairs_.size() && pairs_.scanPoint(next_pair) == i)
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
    if (pairs_.size() == 0) return;
    result.known_share = static_cast<double>(pairs_.size()) / static_cast<double>(countKnown());
    Eigen::Matrix3d& h = result.information;
    double sum = 0;
    for (std::size_t i = 0; i < pairs_.size(); ++i)
    {
        const PairTable::Pair pair = pairs_.at(i);
        sum += pair.squared_distance;
        const LineField::Line& line = lines_.at(pair.neighbour);
        const double jx = result.correction.y - pair.y, jy = pair.x - result.correction.x;
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

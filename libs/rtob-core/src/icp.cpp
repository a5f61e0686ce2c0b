// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/icp.h>
#include <rtob/core/option_checks.h>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr std::size_t kMinPairs = 3;
// While the pair distance shrinks, steps so many times the last one's bring it to the end at once.
constexpr double kCoarseRest = 10;
// Ground is known where the reference has a point within this many pair distances.
constexpr double kKnownReach = 3;
// A pair that lies on no line constrains both directions; one on a line, this little along it.
constexpr double kAlongLine = 0.02;
// Range noise and the points' own spread: no covariance is better than this allows.
constexpr double kMinVariance = 0.01 * 0.01;
// Neighbouring beams err alike, on the same line of the reference: so many pairs count as one.
// Measured as the NEES of eight simulated worlds (docs/evaluation.md).
constexpr double kPairsAlike = 4;
// The normals of bare walls are off by about this [rad]; so much information is none.
constexpr double kNormalNoise = 0.03;
// So that a direction without any information is very uncertain, and not no number.
constexpr double kLeastInformation = 1e-6;

/// Takes from the weakest direction of translation what the walls' noise feigns to know along it.
/// @param covariance for 1 m of noise, of so many pairs
Eigen::Matrix3d without_feigned_information(const Eigen::Matrix3d& covariance, double pairs)
{
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> directions;
    directions.computeDirect(covariance.topLeftCorner<2, 2>().eval());
    const double variance = directions.eigenvalues()(1);
    const double known = 1 / variance - kNormalNoise * kNormalNoise * pairs;
    const Eigen::Vector2d longest = directions.eigenvectors().col(1);
    Eigen::Matrix3d honest = covariance;
    honest.topLeftCorner<2, 2>() +=
        (1 / std::max(kLeastInformation, known) - variance) * longest * longest.transpose();
    return honest;
}

/// What holds the direction, of the two of translation, that the pairs leave open: the start pulls
/// along it with what the pairs lack of the share asked for.
Eigen::Matrix2d hold_of_weak_direction(const Eigen::Matrix3d& information, double weak_share)
{
    const Eigen::Matrix2d of_translation = information.topLeftCorner<2, 2>();
    const double wanted = weak_share * of_translation.trace();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> directions;
    directions.computeDirect(of_translation);  // the least comes first
    const Eigen::Vector2d weakest = directions.eigenvectors().col(0);
    return std::max(0.0, wanted - directions.eigenvalues()(0)) * weakest * weakest.transpose();
}
}  // namespace

WeakDirection weak_direction(const Eigen::Matrix3d& information)
{
    const double both = information(0, 0) + information(1, 1);
    if (!(both > 0)) return {};
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> directions;
    directions.computeDirect(information.topLeftCorner<2, 2>().eval());
    const Eigen::Vector2d weakest = directions.eigenvectors().col(0);
    const double angle_rad = std::atan2(weakest.y(), weakest.x());
    constexpr double half_turn = 3.14159265358979323846;
    return {
        std::clamp(directions.eigenvalues()(0) / both, 0.0, 0.5),
        angle_rad - half_turn * std::floor(angle_rad / half_turn + 0.5)};
}

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
    require(weak_share >= 0 && weak_share <= 0.5, "weak_share", weak_share, "in [0, 0.5]");
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

void Icp::prepare(const PointsView& points, IcpReference& reference) const
{
    reference.build(
        points, options_.max_pair_distance_m, static_cast<std::uint32_t>(options_.cell_points),
        options_.line_radius_m);
}

IcpResult Icp::align(
    const PointsView& scan, const PointsView& reference, const CorrectionPrior& prior)
{
    prepare(reference, own_reference_);
    return align(scan, own_reference_, Eigen::Vector2d::Zero(), prior);
}

IcpResult Icp::align(
    const PointsView& scan, IcpReference& reference, const Eigen::Vector2d& origin,
    const CorrectionPrior& prior, IcpReach reach)
{
    IcpResult result;
    const Pose2 start{origin.x(), origin.y(), 0};
    Pose2 pose = start;  // of the scan, seen from the reference's origin
    const bool to_line = options_.metric == IcpMetric::PointToLine;
    takeMemory(scan.size);
    pairs_.reset(scan.size);
    correspondences_.reset(scan.size);
    const int final_phase = (options_.iterations + 1) / 2;  // from here the pair distance is final
    for (int phase = 0; phase < options_.iterations; ++phase)
    {
        const double distance_m = pairDistance(phase, reach);
        pairs_.move(scan, pose);
        correspondences_.find(reference, distance_m, to_line, pairs_);
        if (pairs_.pairs() < kMinPairs) break;
        pairs_.weigh(
            options_.kernel, options_.kernel_scale_m * distance_m / options_.final_pair_distance_m,
            to_line);
        const Pose2 before = pose;
        pose = fit(before, start, prior);
        ++result.iterations;
        const bool is_final = phase >= final_phase;
        if (!isAtRest(before, pose, (is_final ? 1 : kCoarseRest) * options_.stop_step_m)) continue;
        if (is_final) break;
        phase = final_phase - 1;
    }
    pairs_.move(scan, pose);
    correspondences_.find(reference, options_.final_pair_distance_m, to_line, pairs_);
    result.correction = {pose.x - start.x, pose.y - start.y, pose.yaw};
    describe(reference, pose, result);
    return result;
}

/// Scans differ a little in size, and a later one is to find room.
void Icp::takeMemory(std::size_t scan_points)
{
    constexpr std::size_t block = 256;
    const std::size_t room = (scan_points + block - 1) / block * block;
    pairs_.reserve(room);
    correspondences_.reserve(room);
}

bool Icp::isAtRest(const Pose2& before, const Pose2& now, double step_m)
{
    // 1 m: where the turn's share of the step is measured.
    return std::hypot(now.x - before.x, now.y - before.y) + std::abs(now.yaw - before.yaw) < step_m;
}

/// Shrinks from the largest to the final distance over the first half of the iterations.
double Icp::pairDistance(int iteration, IcpReach reach) const
{
    const double progress = 2.0 * iteration / options_.iterations;
    if (progress >= 1 || reach == IcpReach::Near) return options_.final_pair_distance_m;
    return options_.max_pair_distance_m *
           std::pow(options_.final_pair_distance_m / options_.max_pair_distance_m, progress);
}

/// Point to point in closed form (2.1.3); anything else by one Gauss-Newton step, in which pairs
/// pull across their line, or both ways where there is none. Along a corridor the pairs say next to
/// nothing, but a few wrong ones would carry the pose away: there the start holds it.
Pose2 Icp::fit(const Pose2& pose, const Pose2& start, const CorrectionPrior& prior) const
{
    if (options_.metric == IcpMetric::PointToPoint && prior.information.isZero(0))
        return compose(pairs_.rigidMotion(), pose);
    const auto [h, g] = pairs_.normalEquations(pose.x, pose.y, kAlongLine);
    const Eigen::Vector3d correction(pose.x - start.x, pose.y - start.y, pose.yaw);
    Eigen::Matrix3d held = prior.information;
    held.topLeftCorner<2, 2>() += hold_of_weak_direction(h, options_.weak_share);
    const Eigen::Vector3d step = (h + held).ldlt().solve(-(g + held * correction));
    if (!step.allFinite()) return pose;
    return {pose.x + step(0), pose.y + step(1), pose.yaw + step(2)};
}

/// How many of the scan's points lie where the reference has something near, paired or not.
std::size_t Icp::countKnown(const NeighbourGrid& reference) const
{
    const auto reach = static_cast<float>(kKnownReach * options_.max_pair_distance_m);
    const PointsView points = pairs_.points();
    std::size_t known = pairs_.pairs();
    for (std::size_t i = 0; i < points.size; ++i)
        if (!pairs_.isPaired(i) &&
            reference.nearest(points.x[i], points.y[i], reach).index != NeighbourGrid::kNone)
            ++known;
    return known;
}

/// Error, share and covariance of the final pairs. The information counts each pair across its
/// local line only, because along a wall a neighbour is always near: so a corridor shows as long.
void Icp::describe(IcpReference& reference, const Pose2& pose, IcpResult& result)
{
    result.pairs = pairs_.pairs();
    if (result.pairs == 0) return;
    const auto pairs = static_cast<double>(result.pairs);
    const PointsView points = pairs_.points();
    result.paired_share = pairs / static_cast<double>(points.size);
    result.known_share = pairs / static_cast<double>(countKnown(reference.grid()));
    Eigen::Matrix3d& h = result.information;
    double sum = 0;
    for (std::size_t i = 0; i < points.size; ++i)
    {
        if (!pairs_.isPaired(i)) continue;
        sum += pairs_.squaredDistance(i);
        const LineField::Line& line = reference.line(correspondences_.neighbour(i));
        const double jx = pose.y - points.y[i], jy = points.x[i] - pose.x;
        const Eigen::Vector3d across(
            line.normal_x, line.normal_y, line.normal_x * jx + line.normal_y * jy);
        h += across * across.transpose();
    }
    result.mean_squared_error = sum / pairs;
    const double variance = std::max(kMinVariance, result.mean_squared_error);
    result.covariance = kPairsAlike * variance *
                        without_feigned_information(
                            (h + kLeastInformation * Eigen::Matrix3d::Identity()).inverse(), pairs);
}
}  // namespace rtob

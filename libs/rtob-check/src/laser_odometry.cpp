// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/laser_odometry.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace rtob
{
namespace
{
constexpr std::size_t kKeyScans = 6;
constexpr double kKeyDistance_m = 0.3, kKeyTurn_rad = 0.2;
constexpr std::size_t kMinPairs = 20;
constexpr double kGoodShare = 0.75, kLeastShare = 0.55;
// Below this information a pair along the weakest direction, it is open: half a degree off a
// corridor's axis for every beam, or one beam in 25 against its end.
constexpr double kMinInformation = 0.04;
// Two guesses within this lead to the same match.
constexpr double kSameGuess_m = 0.08, kSameGuess_rad = 0.04;
constexpr std::size_t kSearchPoints = 120;
constexpr SearchWindow kSearchWindow{1.2, 1.0};

/// All that matters is set: a witness should not change when the pipeline is tuned.
IcpOptions icp_options()
{
    IcpOptions options;
    options.max_pair_distance_m = 0.6;
    options.final_pair_distance_m = 0.15;
    options.kernel_scale_m = 0.15;
    options.line_radius_m = 0.15;
    options.iterations = 20;
    options.cell_points = 3;
    options.stop_step_m = 0.001;
    return options;
}

bool is_usable(const IcpResult& fit)
{
    return fit.pairs >= kMinPairs && fit.paired_share >= kLeastShare;
}

bool holds_position(const IcpResult& fit)
{
    const Eigen::Matrix2d a_pair =
        fit.information.topLeftCorner<2, 2>() / static_cast<double>(fit.pairs);
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(a_pair, Eigen::EigenvaluesOnly)
               .eigenvalues()(0) >= kMinInformation;
}

Points moved_points(const Points& points, const Pose2& pose)
{
    const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
    Points moved;
    moved.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        moved.add(
            static_cast<float>(pose.x + c * points.x[i] - s * points.y[i]),
            static_cast<float>(pose.y + s * points.x[i] + c * points.y[i]));
    return moved;
}
}  // namespace

LaserOdometry::LaserOdometry() : icp_(icp_options()) {}

LaserStep LaserOdometry::add(
    const Points& points_vehicle, const std::optional<Pose2>& odometry_step)
{
    LaserStep step;
    if (points_vehicle.size() < kMinPairs)
    {
        key_scans_.clear();
        return step;
    }
    if (key_scans_.empty())
    {
        restart(points_vehicle);
        return step;
    }
    const Match match = matchBest(points_vehicle, odometry_step);
    step.is_measured = is_usable(match.fit);
    step.paired_share = match.fit.paired_share;
    step.pose_prev_now = between(pose_local_vehicle_, match.pose_local_vehicle);
    if (!step.is_measured)
    {
        restart(points_vehicle);
        return step;
    }
    step.holds_position = holds_position(match.fit);
    last_step_ = step.pose_prev_now;
    pose_local_vehicle_ = match.pose_local_vehicle;
    const bool is_new_ground = !is_near(
        key_scans_.back().pose_local_vehicle, pose_local_vehicle_, kKeyDistance_m, kKeyTurn_rad);
    if (is_new_ground) keep(points_vehicle);
    return step;
}

/// The laser's own guess first; the odometry's only where it says something else.
LaserOdometry::Match LaserOdometry::matchBest(
    const Points& points_vehicle, const std::optional<Pose2>& odometry_step)
{
    Match best = matchFrom(points_vehicle, compose(pose_local_vehicle_, last_step_));
    const auto try_step = [&](const Pose2& pose_prev_now)
    {
        const Pose2 guess = compose(pose_local_vehicle_, pose_prev_now);
        if (is_near(guess, best.pose_local_vehicle, kSameGuess_m, kSameGuess_rad)) return;
        const Match other = matchFrom(points_vehicle, guess);
        if (other.fit.paired_share > best.fit.paired_share) best = other;
    };
    if (odometry_step) try_step(*odometry_step);
    if (best.fit.paired_share >= kGoodShare) return best;
    try_step({});
    if (best.fit.paired_share >= kGoodShare) return best;
    const Match found = search(points_vehicle);
    return found.fit.paired_share > best.fit.paired_share ? found : best;
}

void LaserOdometry::prepare(const Points& points_vehicle, const Pose2& pose_local_guess)
{
    turned_ = moved_points(points_vehicle, {0, 0, pose_local_guess.yaw});
    reference_.clear();
    const auto x = static_cast<float>(pose_local_guess.x);
    const auto y = static_cast<float>(pose_local_guess.y);
    for (const KeyScan& key : key_scans_)
        for (std::size_t i = 0; i < key.points_local.size(); ++i)
            reference_.add(key.points_local.x[i] - x, key.points_local.y[i] - y);
}

LaserOdometry::Match LaserOdometry::matchFrom(
    const Points& points_vehicle, const Pose2& pose_local_guess)
{
    prepare(points_vehicle, pose_local_guess);
    Match match;
    match.fit = icp_.align(turned_.view(), reference_.view());
    match.pose_local_vehicle = apply_correction(pose_local_guess, match.fit.correction);
    return match;
}

LaserOdometry::Match LaserOdometry::search(const Points& points_vehicle)
{
    prepare(points_vehicle, pose_local_vehicle_);
    Points thinned;
    const std::size_t stride = turned_.size() / kSearchPoints + 1;
    for (std::size_t i = 0; i < turned_.size(); i += stride)
        thinned.add(turned_.x[i], turned_.y[i]);
    const SearchResult found = search_.search(thinned.view(), reference_.view(), kSearchWindow);
    return matchFrom(points_vehicle, apply_correction(pose_local_vehicle_, found.correction));
}

void LaserOdometry::keep(const Points& points_vehicle)
{
    key_scans_.push_back({pose_local_vehicle_, moved_points(points_vehicle, pose_local_vehicle_)});
    if (key_scans_.size() > kKeyScans) key_scans_.pop_front();
}

/// Starts anew at the origin: so that floats stay exact on long drives through gaps, too.
void LaserOdometry::restart(const Points& points_vehicle)
{
    key_scans_.clear();
    pose_local_vehicle_ = {};
    last_step_ = {};
    keep(points_vehicle);
}
}  // namespace rtob

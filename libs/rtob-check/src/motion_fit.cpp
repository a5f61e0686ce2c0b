// SPDX-License-Identifier: BSD-3-Clause
// Scale, drift, reverse and mount from two accounts of one drive.
#include <rtob/check/motion_steps.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace rtob
{
namespace
{
constexpr double kMadToSigma = 1.4826;

double median_of(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// A stretch that is long enough for the noise of single steps not to matter.
struct Stretch
{
    double laser_rad = 0, odometry_rad = 0, path_m = 0;
};

std::vector<Stretch> stretches_of(const MotionSteps& steps)
{
    constexpr double turn_rad = 1, path_m = 3;
    std::vector<Stretch> stretches;
    Stretch now;
    for (const auto& step : steps)
    {
        if (!step.is_measured)
        {
            now = {};
            continue;
        }
        now.laser_rad += step.laser.yaw;
        now.odometry_rad += step.odometry.yaw;
        now.path_m += std::hypot(step.laser.x, step.laser.y);
        if (std::abs(now.laser_rad) + std::abs(now.odometry_rad) < turn_rad && now.path_m < path_m)
            continue;
        stretches.push_back(now);
        now = {};
    }
    return stretches;
}

/// The normal equations of odometry = scale * laser + drift * path.
struct TurnEquations
{
    double ll = 0, lp = 0, pp = 0, lo = 0, po = 0;

    void add(const Stretch& s, double weight)
    {
        ll += weight * s.laser_rad * s.laser_rad;
        lp += weight * s.laser_rad * s.path_m;
        pp += weight * s.path_m * s.path_m;
        lo += weight * s.laser_rad * s.odometry_rad;
        po += weight * s.path_m * s.odometry_rad;
    }
    [[nodiscard]] double determinant() const { return ll * pp - lp * lp; }
};
}  // namespace

std::optional<TurnFit> fit_turns(const MotionSteps& steps)
{
    constexpr std::size_t fewest = 8;
    constexpr double least_turn_rad = 6;
    constexpr int rounds = 20;
    constexpr double huber = 1.5, least_noise_rad = 1e-4;
    const auto stretches = stretches_of(steps);
    double turn_rad = 0;
    for (const auto& stretch : stretches) turn_rad += std::abs(stretch.laser_rad);
    if (stretches.size() < fewest || turn_rad < least_turn_rad) return std::nullopt;

    TurnFit fit;
    fit.scale.value = 1;
    for (int round = 0; round < rounds; ++round)
    {
        std::vector<double> errors;
        for (const auto& s : stretches)
            errors.push_back(std::abs(
                s.odometry_rad - fit.scale.value * s.laser_rad - fit.drift_rad_per_m * s.path_m));
        const double noise_rad = std::max(least_noise_rad, kMadToSigma * median_of(errors));
        TurnEquations equations;
        for (std::size_t i = 0; i < stretches.size(); ++i)
            equations.add(stretches[i], std::min(1.0, huber * noise_rad / (errors[i] + 1e-12)));
        const double d = equations.determinant();
        // A vehicle that only turns on the spot tells nothing of a drift over the path.
        const bool is_path = d > 1e-6 * equations.ll * equations.ll;
        fit.scale.value = is_path ? (equations.lo * equations.pp - equations.po * equations.lp) / d
                                  : equations.lo / equations.ll;
        fit.drift_rad_per_m =
            is_path ? (equations.ll * equations.po - equations.lp * equations.lo) / d : 0;
        fit.scale.deviation = noise_rad / std::sqrt(is_path ? d / equations.pp : equations.ll);
    }
    return fit;
}

std::optional<Estimate> fit_travel(const MotionSteps& steps)
{
    constexpr double stretch_m = 0.5, most_turn_rad = 0.35;
    constexpr std::size_t fewest = 5;
    std::vector<double> ratios;
    double laser_m = 0, odometry_m = 0, turn_rad = 0;
    for (const auto& step : steps)
    {
        if (!step.is_measured || !step.holds_position)
        {
            laser_m = odometry_m = turn_rad = 0;
            continue;
        }
        const Pose2 &laser = step.laser, &odometry = step.odometry;
        laser_m += std::copysign(std::hypot(laser.x, laser.y), laser.x);
        odometry_m += std::copysign(std::hypot(odometry.x, odometry.y), odometry.x);
        turn_rad += std::abs(laser.yaw);
        if (std::abs(laser_m) < stretch_m) continue;
        if (turn_rad < most_turn_rad) ratios.push_back(odometry_m / laser_m);
        laser_m = odometry_m = turn_rad = 0;
    }
    if (ratios.size() < fewest) return std::nullopt;
    Estimate scale;
    scale.value = median_of(ratios);
    std::vector<double> errors;
    for (const double ratio : ratios) errors.push_back(std::abs(ratio - scale.value));
    scale.deviation =
        kMadToSigma * median_of(errors) / std::sqrt(static_cast<double>(ratios.size()));
    return scale;
}

std::optional<HeadingErrors> heading_errors(const MotionSteps& steps)
{
    constexpr double stretch_m = 10;
    std::vector<double> errors_rad;
    double error_rad = 0, path_m = 0;
    for (const auto& step : steps)
    {
        if (!step.is_measured) continue;
        error_rad += wrap_angle(step.odometry.yaw - step.laser.yaw);
        path_m += std::hypot(step.laser.x, step.laser.y);
        if (path_m < stretch_m) continue;
        errors_rad.push_back(error_rad);
        error_rad = path_m = 0;
    }
    if (errors_rad.empty()) return std::nullopt;
    HeadingErrors errors;
    errors.steady_rad = median_of(errors_rad);
    for (double& error : errors_rad)
    {
        errors.worst_rad = std::max(errors.worst_rad, std::abs(error));
        error = std::abs(error - errors.steady_rad);
    }
    errors.random_rad = median_of(errors_rad);
    return errors;
}

ReverseDriving count_reverse(const MotionSteps& steps)
{
    constexpr double laser_m = 0.03, odometry_m = 0.01;  // more than their noise
    ReverseDriving reverse;
    for (const auto& step : steps)
    {
        if (step.odometry.x < -odometry_m) ++reverse.odometry_ever;
        if (!step.is_measured || !step.holds_position || step.laser.x > -laser_m) continue;
        ++reverse.laser;
        if (step.odometry.x < -odometry_m) ++reverse.odometry;
        if (step.odometry.x < odometry_m) continue;
        ++reverse.forward;
        reverse.forward_m -= step.laser.x;
    }
    return reverse;
}

std::optional<Estimate> find_mount_turn(const MotionSteps& steps)
{
    constexpr double least_m = 0.03, most_turn_rad = 0.05;
    constexpr std::size_t fewest = 20;
    constexpr double least_agreement = 0.7;  // of the directions with each other
    std::complex<double> sum = 0;
    std::size_t used = 0;
    for (const auto& step : steps)
    {
        const std::complex<double> laser(step.laser.x, step.laser.y);
        const std::complex<double> odometry(step.odometry.x, step.odometry.y);
        const bool is_straight = std::abs(step.laser.yaw) < most_turn_rad;
        if (!step.is_measured || !step.holds_position || !is_straight) continue;
        if (std::abs(laser) < least_m || std::abs(odometry) < least_m) continue;
        sum += odometry * std::conj(laser) / (std::abs(odometry) * std::abs(laser));
        ++used;
    }
    if (used < fewest) return std::nullopt;
    const double agreement = std::abs(sum) / static_cast<double>(used);
    if (agreement < least_agreement) return std::nullopt;
    // The deviation of a direction by Mardia, for directions that mostly agree.
    const double spread_rad = std::sqrt(-2 * std::log(std::min(agreement, 1 - 1e-9)));
    return Estimate{std::arg(sum), spread_rad / std::sqrt(static_cast<double>(used))};
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
// The time between odometry and laser.
#include <rtob/check/motion_steps.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr int kMostShift = 3;  // scans
constexpr double kStep = 0.1;  // of a scan
constexpr std::size_t kFewestSteps = 40;
constexpr double kLeastTurn_rad = 1;  // all in all, to tell anything
constexpr double kOutlier_rad = 0.3;  // larger differences say nothing about time
constexpr double kGain = 0.95;        // a shift must lower the differences to this share

/// Heading of the odometry after each step; the first entry is before all.
std::vector<double> headings(const MotionSteps& steps)
{
    std::vector<double> headings_rad{0};
    for (const auto& step : steps) headings_rad.push_back(headings_rad.back() + step.odometry.yaw);
    return headings_rad;
}

double at(const std::vector<double>& values, double place)
{
    const auto before = static_cast<std::size_t>(place);
    const double part = place - static_cast<double>(before);
    if (before + 1 >= values.size()) return values.back();
    return values[before] + part * (values[before + 1] - values[before]);
}

double difference(
    const MotionSteps& steps, const std::vector<double>& headings_rad, double sign, double shift)
{
    double sum = 0;
    for (std::size_t k = kMostShift; k + kMostShift < steps.size(); ++k)
    {
        if (!steps[k].is_measured) continue;
        const double place = static_cast<double>(k) - shift;
        const double turn_rad = at(headings_rad, place + 1) - at(headings_rad, place);
        sum += std::min(kOutlier_rad, std::abs(steps[k].laser.yaw - sign * turn_rad));
    }
    return sum;
}

/// Of the turns over several scans, so that a shift of a scan or two does not hide it.
double correlation(const MotionSteps& steps)
{
    constexpr std::size_t together = 2 * kMostShift;
    double both = 0, laser2 = 0, odometry2 = 0;
    for (std::size_t k = 0; k + together <= steps.size(); k += together)
    {
        double laser = 0, odometry = 0;
        for (std::size_t i = k; i < k + together; ++i)
        {
            if (!steps[i].is_measured) continue;
            laser += steps[i].laser.yaw;
            odometry += steps[i].odometry.yaw;
        }
        both += laser * odometry;
        laser2 += laser * laser;
        odometry2 += odometry * odometry;
    }
    return laser2 > 0 && odometry2 > 0 ? both / std::sqrt(laser2 * odometry2) : 0;
}

Pose2 part_of(const Pose2& step, double part)
{
    return {part * step.x, part * step.y, part * step.yaw};
}
}  // namespace

std::optional<TimeShift> find_time_shift(const MotionSteps& steps)
{
    double laser_rad = 0, odometry_rad = 0;
    for (const auto& step : steps)
    {
        if (step.is_measured) laser_rad += std::abs(step.laser.yaw);
        odometry_rad += std::abs(step.odometry.yaw);
    }
    if (steps.size() < kFewestSteps || std::min(laser_rad, odometry_rad) < kLeastTurn_rad)
        return std::nullopt;
    TimeShift shift;
    const double r = correlation(steps);
    shift.sign = r < 0 ? -1 : 1;
    shift.agreement = std::abs(r);
    const auto headings_rad = headings(steps);
    const double unshifted = difference(steps, headings_rad, shift.sign, 0);
    double least = kGain * unshifted;
    constexpr int most = static_cast<int>(kMostShift / kStep);
    for (int i = -most; i <= most; ++i)
    {
        const double candidate = i * kStep;
        const double sum = difference(steps, headings_rad, shift.sign, candidate);
        if (sum >= least) continue;
        least = sum;
        shift.scans = candidate;
    }
    return shift;
}

MotionSteps shifted(const MotionSteps& steps, const TimeShift& shift)
{
    MotionSteps result;
    if (steps.size() < 2 * kMostShift + 2) return result;
    const double whole = std::floor(-shift.scans);
    const double part = -shift.scans - whole;  // of the step after the whole ones
    for (std::size_t k = kMostShift; k + kMostShift + 1 < steps.size(); ++k)
    {
        const auto i = static_cast<std::size_t>(static_cast<double>(k) + whole);
        const Pose2 &first = steps[i].odometry, &second = steps[i + 1].odometry;
        // What remains of the one step, then the beginning of the next.
        const Pose2 rest = between(part_of(first, part), first);
        MotionStep step = steps[k];
        step.odometry = compose(rest, part_of(second, part));
        result.push_back(step);
    }
    return result;
}
}  // namespace rtob

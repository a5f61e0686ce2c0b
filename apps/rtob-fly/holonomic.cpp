// SPDX-License-Identifier: BSD-3-Clause
#include "holonomic.h"

#include <mrpt/nav/holonomic/CHolonomicFullEval.h>
#include <mrpt/nav/holonomic/CHolonomicND.h>

#include <algorithm>
#include <cmath>

namespace rtob::fly
{
namespace
{
using Eigen::Vector2d;
using Method = mrpt::nav::CAbstractHolonomicReactiveMethod;

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kDirections = 120;
constexpr double kOldest_s = 0.5;  // of the data, as for the other rules

// Defaults of MRPT's reactive navigator: ref_distance, secure_distance_start and _end.
constexpr double kReference_m = 4;
constexpr double kSecureStart = 0.05, kSecureEnd = 0.20;
constexpr double kTooClose = 0.15;  // of both methods: no direction below this is taken

class Holonomic : public Avoider
{
 public:
    Holonomic(std::unique_ptr<Method> method, const VehicleLimits& limits)
        : method_(std::move(method)), limits_(limits)
    {
        // The navigator evaluates no clearance unless told to: it is the same everywhere.
        clearance_.resize(kDirections, kDirections);
        for (std::size_t i = 0; i < kDirections; ++i)
            clearance_.get_path_clearance_decimated(i) = {{0.0, 1.0}, {0.5, 1.0}, {1.0, 1.0}};
    }

    void observe(const GuardScan& scan, const MapPose&) override
    {
        ways_ = free_ways(scan, limits_.clearance(), kDirections, kReference_m);
        for (double& way : ways_) way /= kReference_m;
        time_s_ = scan.end_s();
    }

    GuardDecision decide(double now_s, const Vector2d& wish_vehicle, const VehicleMotion&) override
    {
        const double wished_mps = wish_vehicle.norm();
        const bool is_closed =
            std::all_of(ways_.begin(), ways_.end(), [](double way) { return way < kTooClose; });
        GuardDecision decision;
        decision.reason = wished_mps == 0 ? GuardReason::Free : GuardReason::Blocked;
        if (wished_mps == 0 || is_closed || now_s - time_s_ > kOldest_s) return decision;
        const auto [bearing_rad, share] = navigate(wish_vehicle / wished_mps);
        const double speed_mps = std::min(wished_mps, share * limits_.max_speed_mps);
        if (speed_mps <= 0) return decision;
        decision.velocity_vehicle = {
            speed_mps * std::cos(bearing_rad), speed_mps * std::sin(bearing_rad)};
        decision.bend_rad =
            wrap_angle(bearing_rad - std::atan2(wish_vehicle.y(), wish_vehicle.x()));
        const bool is_bent = std::abs(decision.bend_rad) > 2 * kPi / kDirections;
        decision.reason = is_bent                  ? GuardReason::Guided
                          : speed_mps < wished_mps ? GuardReason::Slowed
                                                   : GuardReason::Free;
        return decision;
    }

 private:
    /// @return the direction to take and the speed, of the largest one
    [[nodiscard]] std::pair<double, double> navigate(const Vector2d& target)
    {
        Method::NavInput in;
        in.obstacles = ways_;
        in.targets = {{target.x(), target.y()}};
        in.clearance = &clearance_;
        Method::NavOutput out;
        try
        {
            method_->navigate(in, out);
        }
        catch (const std::exception&)  // it finds no direction at all
        {
            return {0, 0};
        }
        const double turns = (out.desiredDirection + kPi) / (2 * kPi);
        const auto direction = static_cast<std::size_t>((turns - std::floor(turns)) * kDirections);
        const double way = ways_[std::min(direction, kDirections - 1)];
        const double ramp = (way - kSecureStart) / (kSecureEnd - kSecureStart);
        return {out.desiredDirection, out.desiredSpeed * std::clamp(ramp, 0.0, 1.0)};
    }

    std::unique_ptr<Method> method_;
    VehicleLimits limits_;
    mrpt::nav::ClearanceDiagram clearance_;
    std::vector<double> ways_ = std::vector<double>(kDirections, 0.0);
    double time_s_ = -1e9;
};
}  // namespace

std::unique_ptr<Avoider> make_holonomic(HolonomicMethod method, const VehicleLimits& limits)
{
    std::unique_ptr<Method> made;
    if (method == HolonomicMethod::NearnessDiagram)
        made = std::make_unique<mrpt::nav::CHolonomicND>();
    else
        made = std::make_unique<mrpt::nav::CHolonomicFullEval>();
    return std::make_unique<Holonomic>(std::move(made), limits);
}
}  // namespace rtob::fly

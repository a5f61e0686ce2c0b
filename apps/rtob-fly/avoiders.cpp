// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/nearest_name.h>

#include <stdexcept>

#include "holonomic.h"
#include "rules.h"

namespace rtob::fly
{
namespace
{
class OurGuard : public Avoider
{
 public:
    OurGuard(const VehicleLimits& limits, const GuardOptions& options) : guard_(limits, options) {}

    void observe(const GuardScan& scan, const MapPose& pose) override
    {
        guard_.observe(scan, pose);
    }
    GuardDecision decide(
        double now_s, const Eigen::Vector2d& wish_vehicle, const VehicleMotion& motion) override
    {
        return guard_.decide(now_s, wish_vehicle, motion);
    }

 private:
    VelocityGuard guard_;
};

/// The pilot alone.
class None : public Avoider
{
 public:
    explicit None(const VehicleLimits& limits) : max_speed_mps_(limits.max_speed_mps) {}

    void observe(const GuardScan&, const MapPose&) override {}
    GuardDecision decide(double, const Eigen::Vector2d& wish_vehicle, const VehicleMotion&) override
    {
        GuardDecision decision;
        decision.velocity_vehicle = wish_vehicle;
        const double wished_mps = wish_vehicle.norm();
        if (wished_mps > max_speed_mps_) decision.velocity_vehicle *= max_speed_mps_ / wished_mps;
        decision.reason = GuardReason::Free;
        return decision;
    }

 private:
    double max_speed_mps_;
};
}  // namespace

std::vector<std::string> avoider_names()
{
#ifdef RTOB_HAVE_MRPT_NAV
    return {"guard", "px4", "ardupilot", "mrpt-nd", "mrpt-fulleval", "none"};
#else
    return {"guard", "px4", "ardupilot", "none"};
#endif
}

std::unique_ptr<Avoider> make_avoider(
    const std::string& name, const VehicleLimits& limits, const GuardOptions& options)
{
    if (name == "guard") return std::make_unique<OurGuard>(limits, options);
    if (name == "px4") return std::make_unique<CollisionPrevention>(limits);
    if (name == "ardupilot") return std::make_unique<SimpleAvoidance>(limits);
#ifdef RTOB_HAVE_MRPT_NAV
    if (name == "mrpt-nd") return make_holonomic(HolonomicMethod::NearnessDiagram, limits);
    if (name == "mrpt-fulleval") return make_holonomic(HolonomicMethod::FullEvaluation, limits);
#endif
    if (name == "none") return std::make_unique<None>(limits);
    throw std::invalid_argument("no avoider '" + name + "'" + suggestion(name, avoider_names()));
}
}  // namespace rtob::fly

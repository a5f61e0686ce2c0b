// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/velocity_guard.h>

#include <memory>
#include <string>
#include <vector>

namespace rtob::fly
{
/// Something that turns a pilot's wish into a velocity: our guard, or a rule to compare it with.
class Avoider
{
 public:
    virtual ~Avoider() = default;

    virtual void observe(const GuardScan& scan, const MapPose& pose) = 0;
    [[nodiscard]] virtual GuardDecision decide(
        double now_s, const Eigen::Vector2d& wish_vehicle, const VehicleMotion& motion) = 0;
};

/// Names of all there are: "guard" is ours, "none" lets every wish pass, the others are those of
/// rules.h and, where MRPT's navigation was there at build time, of holonomic.h.
[[nodiscard]] std::vector<std::string> avoider_names();

/// @throws std::invalid_argument that lists the names
[[nodiscard]] std::unique_ptr<Avoider> make_avoider(
    const std::string& name, const VehicleLimits& limits, const GuardOptions& options);
}  // namespace rtob::fly

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/convex_area.h>
#include <rtob/avoid/vehicle_limits.h>

namespace rtob
{
/// Where the vehicle's middle can be until it stands, if it is given one more command and then
/// told to stop. docs/avoidance.md derives it; in short: at every moment the velocity is a mixture
/// of those that still act (the measured one, those commanded within the latency) and the new one.
/// The old ones act for old_s at most, and after total_s all is over, both in seconds of full
/// speed. So the place is a sum  a * old + b * command  with  a <= old_s  and  a + b <= total_s.
///
/// The vehicle is at the origin; axes do not turn.
class StoppingArea
{
 public:
    explicit StoppingArea(const VehicleLimits& options);

    /// @param velocities that act on the vehicle now; at most kMaxVelocities. m/s
    void setActing(const Eigen::Vector2d* velocities, std::size_t count);

    [[nodiscard]] ConvexArea of(const Eigen::Vector2d& command) const;

    /// Holds the areas of this command and of all slower ones in its direction.
    [[nodiscard]] ConvexArea ofUpTo(const Eigen::Vector2d& command) const;

    /// No area reaches farther for commands up to this speed.
    [[nodiscard]] double reach(double speed_mps) const;

    static constexpr std::size_t kMaxVelocities = 32;

 private:
    [[nodiscard]] double oldTime(const Eigen::Vector2d& command) const;
    [[nodiscard]] double totalTime(double fastest_mps) const;

    double latency_s_, response_s_, period_s_, braking_mps2_;
    ConvexArea acting_;  ///< in m/s
    double fastest_acting_mps_ = 0;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace rtob
{
/// [Pilot]: whether and how a pilot's sticks fly the vehicle under the obstacle guard.
struct PilotOptions
{
    bool enabled = false;
    double command_hz = 40;
    double max_motion_age_s = 0.3;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit(
            "enabled", s.enabled,
            "send velocities: the pilot's wish as far as the obstacle guard allows it");
        visit(
            "command_hz", s.command_hz,
            "how often is decided and sent; at least 2 / [VehicleLimits] period_s, at most 100");
        visit(
            "max_motion_age_s", s.max_motion_age_s,
            "older velocities and attitudes of the autopilot are not used; 0.05 to 1");
    }
    void validate() const;
};
}  // namespace rtob

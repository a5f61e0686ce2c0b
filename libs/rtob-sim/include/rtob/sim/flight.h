// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/sim/shape.h>
#include <rtob/sim/vehicle.h>

#include <vector>

/// Flights by a script, for logs.
namespace rtob::sim
{
enum class Heading
{
    Fixed,  ///< as at the start
    Ahead,  ///< where it flies to
    Spin    ///< turning all the time
};

constexpr auto enum_names(Heading)
{
    return std::array<std::pair<Heading, std::string_view>, 3>{
        {{Heading::Fixed, "fixed"}, {Heading::Ahead, "ahead"}, {Heading::Spin, "spin"}}};
}

struct Waypoint
{
    Point2 at_map;
    double altitude_m = 1;
    double hold_s = 0;  ///< it waits there
};

struct FlightPlan
{
    std::vector<Waypoint> route;  ///< from the start on; empty: hover
    double speed_mps = 0.5;
    double climb_mps = 0.4;
    Heading heading = Heading::Fixed;
    double yaw_rate_dps = 30;  ///< of Heading::Spin
    double duration_s = 60;
    bool repeat = true;  ///< from the last waypoint to the first and round again; else it stays
};

/// Where the script wants the vehicle.
struct FlightTarget
{
    Point2 at_map;
    double altitude_m = 0;
    double vx_map_mps = 0, vy_map_mps = 0, climb_mps = 0;
};

/// A pilot that knows the truth and flies a plan.
class Pilot
{
 public:
    Pilot(const FlightPlan& plan, const Pose3& start_map);

    [[nodiscard]] FlightTarget target(double time_s) const;
    [[nodiscard]] VelocityCommand command(
        double time_s, const VehicleState& state, VehicleKind kind) const;

 private:
    struct Leg
    {
        double start_s = 0, move_s = 0;  ///< it moves first, then waits until the next leg
        Waypoint from, to;
    };

    void addLeg(const Waypoint& from, const Waypoint& to);
    [[nodiscard]] double yawRate(
        double time_s, Point2 wished_mps, double speed_mps, double yaw_rad, VehicleKind kind) const;

    FlightPlan plan_;
    Pose3 start_map_;
    std::vector<Leg> legs_;
    double end_s_ = 0;           ///< of the first round
    double repeats_from_s_ = 0;  ///< the leg from the last waypoint to the first starts the rounds
};
}  // namespace rtob::sim

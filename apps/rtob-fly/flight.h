// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "avoider.h"
#include "fly_world.h"
#include "pilot.h"

namespace rtob::fly
{
/// How badly vehicle, laser and link behave, within what the guard is told about them, and how
/// much the vehicle brakes less than stated.
struct Hardship
{
    bool always_latest = false;       ///< every command takes the whole latency
    double acceleration_share = 0.8;  ///< of the stated one
    double range_noise_m = 0.01;
    double dropout = 0.02;
    double velocity_noise_mps = 0.05;
    double pose_noise_m = 0.01;
    double turbulence_mps2 = 0.1;
    double scan_delay_s = 0.05;      ///< from its last beam until the guard has it
    bool holds_place = true;         ///< told to stand still, the autopilot holds its place
    double field_of_view_deg = 360;  ///< the laser's; with less, it looks around once at first
};

struct FlightSetup
{
    std::string avoider = "guard";
    PilotKind pilot = PilotKind::Scripted;
    std::uint64_t seed = 1;
    double duration_s = 60;          ///< after a look around
    std::optional<Pose2> start_map;  ///< else drawn in the world's area
    VehicleLimits limits;
    GuardOptions options;
    Hardship hardship;
};

/// The vehicle as the flights have it: small enough for the doors of a flat.
[[nodiscard]] VehicleLimits fly_limits();
[[nodiscard]] GuardOptions fly_options();

/// One moment of a flight, for pictures.
struct FlightFrame
{
    double time_s = 0;
    Pose2 pose_map_vehicle;
    Eigen::Vector2d wish_map = Eigen::Vector2d::Zero();
    Eigen::Vector2d command_map = Eigen::Vector2d::Zero();
    GuardReason reason = GuardReason::NoData;
    Points hits_map;
};

struct FlightResult
{
    int contacts = 0;          ///< times the disc touched something
    double least_gap_m = 1e9;  ///< between disc and things
    double flown_m = 0;
    double wished_m = 0;      ///< what the pilot asked for, no more than the vehicle's top speed
    double along_wish_m = 0;  ///< how much of it came true
    int side_changes = 0;     ///< of the bend, from left to right or back
    std::uint64_t decisions = 0;
    double decision_s = 0;  ///< processor time of observing and deciding, all together
    std::array<std::uint64_t, 7> reasons{};
    Pose2 end_map;
    std::vector<FlightFrame> frames;  ///< where asked for
};

/// Flies once. Same world, setup: the same numbers, processor time apart.
/// @param frame_every_s 0: no frames
[[nodiscard]] FlightResult fly(
    const FlyWorld& world, const FlightSetup& setup, double frame_every_s = 0);
}  // namespace rtob::fly

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "flight.h"

namespace rtob::fly
{
/// Many flights: all worlds with all pilots in turn, half of them with the longest latency always.
struct CampaignPlan
{
    std::string avoider = "guard";
    std::vector<std::string> worlds;
    std::vector<PilotKind> pilots{PilotKind::Scripted, PilotKind::Random, PilotKind::Malicious};
    std::uint64_t flights = 12;
    std::uint64_t first = 0;  ///< number of the first flight, which decides world, pilot and seed
    double duration_s = 60;
    bool holds_place = true;         ///< Hardship's
    double field_of_view_deg = 360;  ///< Hardship's
    unsigned jobs = 1;
};

/// What came out of flights, summed up.
struct CampaignTally
{
    std::uint64_t flights = 0, flights_with_contact = 0, contacts = 0, side_changes = 0;
    std::uint64_t decisions = 0;
    double flown_s = 0, flown_m = 0, wished_m = 0, along_wish_m = 0, decision_s = 0;
    double least_gap_m = 1e9;
    std::uint64_t least_gap_flight = 0;
    std::array<std::uint64_t, 7> reasons{};
    std::vector<std::uint64_t> contact_flights;  ///< numbers of the first few

    void add(std::uint64_t number, const FlightSetup& setup, const FlightResult& result);
    CampaignTally& operator+=(const CampaignTally& other);
};

/// The flight of a number: its world and all that is drawn for it.
struct NumberedFlight
{
    std::string world;
    FlightSetup setup;
};
[[nodiscard]] NumberedFlight numbered_flight(const CampaignPlan& plan, std::uint64_t number);

/// @param progress hears how many flights are done; may be called from any thread, one at a time
[[nodiscard]] CampaignTally run_campaign(
    const CampaignPlan& plan, const std::function<void(std::uint64_t)>& progress);

/// How many of so many flights straight at a door, off its middle and askew, end behind it. A laser
/// that does not see all around looks towards the door.
struct DoorTally
{
    int tries = 0, passed = 0;
    CampaignTally flights;
};
[[nodiscard]] DoorTally try_doors(
    const std::string& avoider, int tries, double field_of_view_deg = 360);
}  // namespace rtob::fly

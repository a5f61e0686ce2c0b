// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "flight.h"

namespace rtob::fly
{
/// Draws the whole flight from above: walls, the path coloured by what the guard did, start, end.
/// Writes a PNG; throws std::runtime_error when it cannot be written.
void write_flight_picture(
    const std::string& file, const FlyWorld& world, const FlightSetup& setup,
    const FlightResult& result);

/// Moments of the flight side by side, like frames of a film: the last scan, the vehicle with its
/// margin, an arrow for the wish and one for what is flown.
void write_flight_strip(
    const std::string& file, const FlyWorld& world, const FlightSetup& setup,
    const FlightResult& result, std::size_t frames);
}  // namespace rtob::fly

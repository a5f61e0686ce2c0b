// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/random.h>

#include <cmath>
#include <string>

#include "room_mrpt.h"
#include "worlds.h"

/// Two rooms with a door between them, and a drive that leads through both: what the vehicle sees
/// of the second room is new to it.
namespace rtob::test
{
[[nodiscard]] inline Room house()
{
    std::vector<Wall> walls{{0, 0, 12, 0},    {12, 0, 12, 6},
                            {12, 6, 0, 6},    {0, 6, 0, 0},         // around
                            {6, 0, 6, 2},     {6, 4, 6, 6},         // the door's wall
                            {0, 4.5, 1, 4.5}, {1, 4.5, 1, 6},       // a cupboard
                            {10, 0, 10, 0.6}, {10, 0.6, 12, 0.6}};  // a bench
    add_circle(walls, 3.0, 3.0, 0.25);
    add_circle(walls, 8.5, 5.2, 0.3);
    return Room(walls);
}

constexpr int house_lap_scans = 400;  // 5 cm and up to 5 degrees a scan

/// A figure of eight whose middle is the door.
[[nodiscard]] inline Pose2 pose_in_house(int scan)
{
    const double a = 2 * 3.14159265358979323846 * scan / house_lap_scans;
    return {
        6 + 4 * std::cos(a), 3 + 1.5 * std::sin(2 * a),
        std::atan2(3 * std::cos(2 * a), -4 * std::sin(a))};
}

/// The same as seen from the first pose: the map's frame.
[[nodiscard]] inline Pose2 pose_in_house_map(int scan)
{
    return between(pose_in_house(0), pose_in_house(scan));
}

/// Normal, by Box and Muller.
[[nodiscard]] inline double gaussian(Random& random, double sigma)
{
    const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    return sigma * radius * std::cos(2 * 3.14159265358979323846 * random.uniform());
}

/// Ten scans a second.
[[nodiscard]] inline mrpt::obs::CObservation2DRangeScan scan_in_house(int scan)
{
    return scan_observation(house(), pose_in_house(scan), 1000 + 0.1 * scan, mrpt_laser());
}

/// The same with noise on every range.
[[nodiscard]] inline mrpt::obs::CObservation2DRangeScan noisy_scan_in_house(
    int scan, double sigma_m, Random& random)
{
    auto noisy = scan_in_house(scan);
    for (std::size_t i = 0; i < noisy.getScanSize(); ++i)
        if (noisy.getScanRangeValidity(i))
            noisy.setScanRange(
                i, noisy.getScanRange(i) + static_cast<float>(gaussian(random, sigma_m)));
    return noisy;
}
}  // namespace rtob::test

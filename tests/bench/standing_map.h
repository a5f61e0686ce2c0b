// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/large_pages.h>
#include <test_map.h>
#include <worlds.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace rtob::bench
{
constexpr double kScanRate_hz = 10;

/// One of the 36 places, in turn, of a vehicle that circles.
inline Pose2 circle_pose(std::size_t i)
{
    const double turn_rad = 0.1745 * static_cast<double>(i % 36);
    return {1.6 + 0.5 * std::cos(turn_rad), 1.3 + 0.5 * std::sin(turn_rad), wrap_angle(turn_rad)};
}

/// A vehicle that has circled in one room for as long as it takes to store this many points: the
/// revisit density always has everything near. 360 points a scan, seen from 36 places in turn, with
/// a range laser's noise: without it points would lie on each other.
inline test::TestMap make_standing_map(std::uint64_t points)
{
    const test::Room room = test::room_4x3();
    std::vector<Pose2> poses;
    std::vector<Points> scans;
    for (std::size_t i = 0; i < 36; ++i)
    {
        poses.push_back(circle_pose(i));
        scans.push_back(test::moved(room.scan_vehicle(poses.back()), poses.back()));
    }
    Random random(1);
    const auto noisy = [&](float v)
    { return v + 0.03f * static_cast<float>(random.uniform() - 0.5); };
    test::TestMap map;
    map.points_map.reserve(points + 360);
    for (const auto* column : {&map.points_map.x, &map.points_map.y})
        prefer_large_pages(column->data(), column->capacity() * sizeof(float));
    map.scans.reserve(points / 360 + 1, points + 360);
    for (std::size_t k = 0; map.points_map.size() < points; ++k)
    {
        const Points& scan = scans[k % 36];
        map.add(
            static_cast<double>(k) / kScanRate_hz, poses[k % 36],
            static_cast<std::uint32_t>(scan.size()),
            [&](std::uint32_t i) { return std::pair(noisy(scan.x[i]), noisy(scan.y[i])); });
    }
    return map;
}

/// The map of this size, made once: benchmarks ask for one size after the other.
inline const test::TestMap& standing_map(std::uint64_t points)
{
    static test::TestMap map;
    static std::uint64_t made = 0;
    if (made != points)
    {
        map = {};  // before the next is made: the largest takes 0.9 GB
        map = make_standing_map(points);
        made = points;
    }
    return map;
}

/// Now, in the middle of the room.
inline Moment now_of(const test::TestMap& map)
{
    return {map.scans.time(map.scans.size() - 1) + 1 / kScanRate_hz, 1.6, 1.3};
}
}  // namespace rtob::bench

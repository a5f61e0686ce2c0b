// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rtob
{
/// A map as a picture in the convention of ROS's map_server.
struct OccupancyImage
{
    static constexpr std::uint8_t occupied = 0, free = 254, unknown = 205;

    std::size_t width = 0, height = 0;  ///< cells
    double resolution_m = 0;            ///< of a cell's side
    Pose2 origin;                       ///< map <- lower left corner of the picture
    std::vector<std::uint8_t> pixels;   ///< row by row, the top row (largest y) first
};

/// Writes <stem>.pgm and <stem>.yaml; each appears whole or not at all. Throws std::runtime_error
/// when they cannot be written, std::invalid_argument for an image whose sizes contradict.
void write_map_server(const std::string& stem, const OccupancyImage& image);
}  // namespace rtob

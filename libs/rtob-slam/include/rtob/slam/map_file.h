// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/slam/slam.h>

#include <cstdint>
#include <string>

/// Maps that stay: one map a file, with a versioned header and a checksum.
namespace rtob
{
/// Appears whole or not at all. Throws std::runtime_error naming the file.
void save_map(const std::string& file, const RtobMap& map);

/// Throws std::runtime_error that names the file, what is wrong with it and what to do.
[[nodiscard]] RtobMap load_map(const std::string& file);

/// Begins in the map that [Map] names, if it names one: at its initial pose, or LOST until the
/// vehicle is found in it. Throws as load_map() does.
void enter_map(Slam& slam);

/// Of all points and scans; the clock, which runs on while a vehicle only localises, is left out.
[[nodiscard]] std::uint32_t map_checksum(const RtobMap& map);
}  // namespace rtob

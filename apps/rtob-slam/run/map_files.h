// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/map/rtob_map.h>

#include <string>
#include <vector>

#include "run/output_folder.h"

namespace rtob
{
struct MapFilesInput
{
    const RtobMap& map;
    std::vector<Pose2> poses_vehicle_laser;  ///< the mount behind each scan of the map
    std::vector<Pose2> path;                 ///< map <- vehicle, of every scan of the log
    double resolution_m = 0.05;              ///< of map.pgm
    std::string title;                       ///< of map.png
    bool wants_map_file = true;              ///< map.rtob, for runs to come
};

/// Writes map.rtob, map.ply and map.pgm with map.yaml; the path and the title are not needed.
/// @return the resolution of map.pgm [m]: coarser than asked where it would have got too large.
double write_map_data(const OutputFolder& folder, const MapFilesInput& input);

/// The same, and map.png.
double write_map_files(const OutputFolder& folder, const MapFilesInput& input);
}  // namespace rtob

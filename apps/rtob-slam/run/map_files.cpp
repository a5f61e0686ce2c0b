// SPDX-License-Identifier: BSD-3-Clause
#include "run/map_files.h"

#include <rtob/io/map_server.h>
#include <rtob/io/occupancy_raster.h>
#include <rtob/map/map_export.h>
#include <rtob/slam/map_file.h>

#include <limits>
#include <stdexcept>

namespace rtob
{
namespace
{
/// Rays from the laser to each stored point. The points lie in map already, so they go in as if the
/// vehicle stood at the map's origin and carried its laser at pose_map_laser.
OccupancyImage cast_rays(const MapFilesInput& input, double resolution_m)
{
    constexpr double all_ranges = std::numeric_limits<double>::infinity();  // filtered already
    OccupancyRaster raster(resolution_m);
    const auto points = input.map.points();
    const auto& scans = input.map.scans();
    for (std::size_t k = 0; k < scans.size(); ++k)
    {
        const auto first = scans.firstPoint(k);
        const PointsView points_map{
            points.x + first, points.y + first, scans.firstPoint(k + 1) - first};
        const Pose2 pose_map_laser = compose(scans.pose(k), input.poses_vehicle_laser.at(k));
        raster.add_scan(Pose2{}, points_map, all_ranges, pose_map_laser);
    }
    return raster.image();
}

double write_occupancy(const std::string& stem, const MapFilesInput& input)
{
    for (double resolution_m = input.resolution_m;; resolution_m *= 2) try
        {
            write_map_server(stem, cast_rays(input, resolution_m));
            return resolution_m;
        }
        catch (const std::length_error&)  // too large a picture: the next one has a quarter
        {
        }
}
}  // namespace

double write_map_data(const OutputFolder& folder, const MapFilesInput& input)
{
    if (input.wants_map_file) save_map(folder.file("map.rtob"), input.map);
    save_ply(input.map, folder.file("map.ply"));
    return write_occupancy(folder.file("map"), input);
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "compare/mrpt_variant.h"

#include <mrpt/config/CConfigFile.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/map/conversions.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace rtob
{
namespace
{
// MRPT's pose estimator wants every stamp to be later than the last; logs repeat theirs.
constexpr double kShortestStep_s = 1e-3;
constexpr double kFirstStamp_s = 1e9;  // any time that MRPT takes for a valid one

VariantMap map_of_points(const mrpt::maps::CPointsMap& points_map)
{
    const PointsView points = view_of(points_map);
    VariantMap map;
    map.size = points.size;
    map.points.x.assign(points.x, points.x + points.size);
    map.points.y.assign(points.y, points.y + points.size);
    return map;
}

VariantMap map_of_grid(const mrpt::maps::COccupancyGridMap2D& grid)
{
    constexpr float occupied = 0.4f;  // the chance to be free; unknown is 0.5
    VariantMap map;
    map.unit = "cells";
    map.size = static_cast<std::uint64_t>(grid.getSizeX()) * grid.getSizeY();
    for (int y = 0; y < static_cast<int>(grid.getSizeY()); ++y)
        for (int x = 0; x < static_cast<int>(grid.getSizeX()); ++x)
            if (grid.getCell(x, y) < occupied) map.points.add(grid.idx2x(x), grid.idx2y(y));
    return map;
}
}  // namespace

MrptVariant::MrptVariant(const std::string& config_file)
{
    if (!std::filesystem::is_regular_file(config_file))
        throw std::runtime_error(
            config_file + " is missing. MRPT's own files come with Debian's package mrpt-common.");
    const mrpt::config::CConfigFile config(config_file);
    builder_.setVerbosityLevel(mrpt::system::LVL_ERROR);
    builder_.ICP_options.loadFromConfigFile(config, "MappingApplication");
    builder_.ICP_params.loadFromConfigFile(config, "ICP");
    builder_.initialize();
    const auto& maps = *builder_.getCurrentlyBuiltMetricMap();
    if (maps.countMapsByClass<mrpt::maps::CPointsMap>() +
            maps.countMapsByClass<mrpt::maps::COccupancyGridMap2D>() ==
        0)
        throw std::runtime_error(
            config_file +
            ": section [MappingApplication] asks for no map that icp-slam can match "
            "against; set pointsMap_count = 1 or occupancyGrid_count = 1.");
}

mrpt::Clock::time_point MrptVariant::stampFor(double time_s)
{
    last_time_s_ = std::max(time_s, last_time_s_ + kShortestStep_s);
    return mrpt::Clock::fromDouble(kFirstStamp_s + last_time_s_);
}

/// The odometry has the scan's own stamp, so that MRPT extrapolates nothing between the two, and no
/// velocities: a rotation of exactly 0 among them makes its poses NaN.
Pose2 MrptVariant::process(const ScanStep& step)
{
    step.scan->timestamp = stampFor(step.time_s);
    if (step.pose_odom_vehicle)
    {
        const auto odometry = mrpt::obs::CObservationOdometry::Create();
        odometry->timestamp = step.scan->timestamp;
        odometry->odometry = to_cpose2d(*step.pose_odom_vehicle);
        builder_.processObservation(odometry);
    }
    builder_.processObservation(step.scan);
    const auto estimate = builder_.getCurrentPoseEstimation();
    return to_pose2(mrpt::poses::CPose2D(estimate->getMeanVal()));
}

VariantMap MrptVariant::map() const
{
    const auto& maps = *builder_.getCurrentlyBuiltMetricMap();
    const auto grid = maps.mapByClass<mrpt::maps::COccupancyGridMap2D>();
    if (builder_.ICP_options.matchAgainstTheGrid && grid) return map_of_grid(*grid);
    if (const auto points = maps.mapByClass<mrpt::maps::CPointsMap>())
        return map_of_points(*points);
    return grid ? map_of_grid(*grid) : VariantMap{};
}
}  // namespace rtob

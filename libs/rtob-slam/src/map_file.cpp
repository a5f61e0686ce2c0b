// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/checked_object.h>
#include <rtob/slam/map_file.h>

#include <memory>
#include <stdexcept>

namespace rtob
{
namespace
{
const ObjectFormat& map_format()
{
    static const ObjectFormat format{"rtob map", 1, "the map.rtob that rtob-slam run writes"};
    return format;
}
}  // namespace

void save_map(const std::string& file, const RtobMap& map)
{
    write_checked_object(file, map_format(), map);
}

RtobMap load_map(const std::string& file)
{
    register_classes();
    const auto object = read_checked_object(file, map_format());
    const auto map = std::dynamic_pointer_cast<RtobMap>(object);
    if (!map) throw std::runtime_error(file + ": holds another object than a map of rtob.");
    return *map;
}

void enter_map(Slam& slam)
{
    const MapOptions& options = slam.options().map;
    if (options.file.empty()) return;
    const RtobMap map = load_map(options.file);
    if (options.localize && map.scans().empty())
        throw std::runtime_error(options.file + ": is empty; name a map to localise in.");
    slam.continueIn(map, options.initialPose());
}

std::uint32_t map_checksum(const RtobMap& map)
{
    Checksum checksum;
    const PointsView points = map.points();
    checksum.add(points.x, points.size * sizeof(float));
    checksum.add(points.y, points.size * sizeof(float));
    for (std::size_t k = 0; k < map.scans().size(); ++k)
    {
        const Pose2 pose = map.scans().pose(k);
        const double columns[] = {
            map.scans().time(k), pose.x, pose.y, pose.yaw,
            static_cast<double>(map.scans().firstPoint(k + 1))};
        checksum.add(columns, sizeof columns);
    }
    return checksum.value();
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "eval/map_file.h"

#include <mrpt/maps/CSimplePointsMap.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace rtob
{
bool is_ply_file(const std::string& file)
{
    constexpr std::string_view mark = "ply";
    std::array<char, mark.size()> beginning{};
    std::ifstream in(file, std::ios::binary);
    return in.read(beginning.data(), beginning.size()) &&
           std::string_view(beginning.data(), beginning.size()) == mark;
}

Points read_ply_points(const std::string& file)
{
    mrpt::maps::CSimplePointsMap map;
    if (!map.loadFromPlyFile(file))
        throw std::runtime_error(
            file + ": " + map.getLoadPLYErrorString() +
            ". Name the map.ply that rtob-slam run wrote, or another PLY file of points.");
    if (map.empty())
        throw std::runtime_error(file + ": the map holds no points. Name one that does.");
    const auto& x = map.getPointsBufferRef_x();
    const auto& y = map.getPointsBufferRef_y();
    Points points;
    points.x.assign(x.begin(), x.end());
    points.y.assign(y.begin(), y.end());
    return points;
}
}  // namespace rtob

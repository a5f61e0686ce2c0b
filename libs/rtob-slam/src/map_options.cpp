// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <rtob/core/option_checks.h>
#include <rtob/map/option_text.h>
#include <rtob/slam/map_options.h>

#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace rtob
{
namespace
{
constexpr int kLeastPoints = 10'000;  // fewer hold no room

[[noreturn]] void refuse_pose(const std::string& text)
{
    throw std::invalid_argument(
        "initial_pose = " + text + ": write x,y,yaw in metres and degrees, for example 1.5,-2,90");
}
}  // namespace

void MapOptions::validate() const
{
    require(
        max_points == 0 || max_points >= kLeastPoints, "max_points", max_points, "0 or >= 10000");
    (void)initialPose();
    if (!file.empty()) return;
    if (localize)
        throw std::invalid_argument("localize: there is no map to localise in; name one with file");
    if (!initial_pose.empty())
        throw std::invalid_argument(
            "initial_pose: a new map begins at 0,0,0; name the map that it means with file");
}

std::optional<Pose2> MapOptions::initialPose() const
{
    if (initial_pose.empty()) return std::nullopt;
    std::array<double, 3> numbers{};
    std::istringstream parts(initial_pose);
    std::string part;
    std::size_t count = 0;
    try
    {
        for (; std::getline(parts, part, ','); ++count) parse_option(part, numbers.at(count));
    }
    catch (const std::exception&)
    {
        refuse_pose(initial_pose);
    }
    if (count != numbers.size() || initial_pose.back() == ',') refuse_pose(initial_pose);
    for (const double number : numbers)
        if (!std::isfinite(number)) refuse_pose(initial_pose);
    return Pose2{numbers[0], numbers[1], wrap_angle(mrpt::DEG2RAD(numbers[2]))};
}
}  // namespace rtob

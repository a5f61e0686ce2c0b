// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <mrpt/system/string_utils.h>
#include <rtob/core/pose2.h>
#include <rtob/map/angle_mask.h>
#include <rtob/map/option_text.h>

#include <stdexcept>

namespace rtob
{
namespace
{
double degrees(const std::string& text)
{
    double value = 0;
    parse_option(mrpt::system::trim(text), value);
    return value;
}
}  // namespace

AngleMask::AngleMask(const std::string& sectors_deg)
{
    std::vector<std::string> sectors;
    mrpt::system::tokenize(sectors_deg, ",", sectors);
    for (const std::string& sector : sectors)
    {
        if (mrpt::system::trim(sector).empty()) continue;
        const auto dots = sector.find("..");
        if (dots == std::string::npos)
            throw std::invalid_argument(
                "mask_deg: '" + sector +
                "' is no sector; write FROM..TO in degrees, e.g. 170..190");
        const double begin_deg = degrees(sector.substr(0, dots));
        const double end_deg = degrees(sector.substr(dots + 2));
        if (end_deg < begin_deg || end_deg - begin_deg > 360)
            throw std::invalid_argument(
                "mask_deg: '" + sector + "' must run upwards, and over at most 360 degrees");
        sectors_.push_back(
            {mrpt::DEG2RAD(begin_deg), mrpt::DEG2RAD(end_deg) - mrpt::DEG2RAD(begin_deg)});
    }
}

bool AngleMask::contains(double bearing_rad) const
{
    for (const Sector& sector : sectors_)
    {
        const double turn = wrap_angle(bearing_rad - sector.begin_rad);
        if (turn >= 0 ? turn <= sector.width_rad : turn + 2 * M_PI <= sector.width_rad) return true;
    }
    return false;
}
}  // namespace rtob

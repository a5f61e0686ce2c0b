// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/beam_grid.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
/// Some room, so that the size stays while the head's speed wavers.
std::size_t size_for(std::size_t beams)
{
    constexpr std::size_t multiple = 8;
    const auto roomy = static_cast<std::size_t>(1.02 * static_cast<double>(beams));
    return (roomy / multiple + 1) * multiple;
}
}  // namespace

void BeamGrid::chooseSize(std::size_t beams)
{
    constexpr int turns_until_smaller = 10;
    if (wanted_ > 0)
    {
        size_ = wanted_;
        return;
    }
    const bool is_much_smaller = 10 * beams < 8 * size_;
    much_smaller_in_a_row_ = is_much_smaller ? much_smaller_in_a_row_ + 1 : 0;
    if (beams > size_ || much_smaller_in_a_row_ >= turns_until_smaller)
    {
        size_ = size_for(beams);
        much_smaller_in_a_row_ = 0;
    }
}

GriddedRevolution BeamGrid::grid(const RplidarRevolution& revolution)
{
    chooseSize(revolution.beams.size());
    GriddedRevolution gridded;
    gridded.ranges_m.assign(size_, 0.0f);
    std::vector<double> off_centre(size_, 1.0);  // in steps; of the beam that a step holds
    for (const auto& beam : revolution.beams)
    {
        const double place = beam.bearing_deg / gridded.stepDeg();
        const std::size_t step = std::min(static_cast<std::size_t>(place), size_ - 1);
        const double off = std::abs(place - static_cast<double>(step) - 0.5);
        // A beam that saw something wins over one that did not; then the nearer to the middle.
        if (beam.range_m > 0 && off < off_centre[step])
        {
            gridded.ranges_m[step] = beam.range_m;
            off_centre[step] = off;
        }
    }
    return gridded;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/revolution_builder.h>

#include <cmath>

namespace rtob
{
namespace
{
/// A standard scan's bearings are put right beam by beam and may step back a little.
constexpr double kStepBack_deg = 5;
constexpr std::size_t kStraysUntilLost = 8;
/// Far above the 3200 beams of the densest device: a stream without a start must not grow for ever.
constexpr std::size_t kMostBeams = 16384;

/// How far the head went on, in [-180, 180].
double step_deg(double from_deg, double to_deg)
{
    return std::remainder(to_deg - from_deg, 360.0);
}
}  // namespace

std::optional<RplidarRevolution> RevolutionBuilder::add(const RplidarBeam& beam)
{
    std::optional<RplidarRevolution> ended;
    if (is_gathering_ && isStray(beam))
    {
        setAside(beam);
        return ended;
    }
    if (beam.starts)
    {
        if (is_gathering_ && isWhole())
        {
            ++revolutions_;
            now_.sweep_s = beam.time_s - now_.start_s;
            ended = std::move(now_);
        }
        else if (is_gathering_)
            ++partial_;
        begin(beam);
    }
    else if (is_gathering_)
        keep(beam);
    return ended;
}

void RevolutionBuilder::forget()
{
    if (is_gathering_ && !now_.beams.empty()) ++partial_;
    is_gathering_ = false;
    now_ = {};
    strays_.clear();
}

bool RevolutionBuilder::isStray(const RplidarBeam& beam) const
{
    const double step = step_deg(last_shaft_deg_, beam.shaft_deg);
    const bool fits = step > -kStepBack_deg && step <= max_gap_deg_;
    const bool starts_too_early = beam.starts && turned_deg_ < 360 - 2 * max_gap_deg_;
    return !fits || starts_too_early;
}

/// One odd beam is left out; many in a row mean that the head really is elsewhere, as bytes were
/// lost. Then they are what there is of a new revolution, if its start is among them.
void RevolutionBuilder::setAside(const RplidarBeam& beam)
{
    ++stray_beams_;
    strays_.push_back(beam);
    if (strays_.size() < kStraysUntilLost) return;
    const auto strays = std::move(strays_);
    forget();
    for (const auto& stray : strays)
        if (stray.starts)
            begin(stray);
        else if (is_gathering_)
            keep(stray);
}

bool RevolutionBuilder::isWhole() const
{
    return turned_deg_ > 360 - max_gap_deg_ && turned_deg_ < 360 + max_gap_deg_;
}

void RevolutionBuilder::begin(const RplidarBeam& beam)
{
    now_ = {};
    now_.start_s = beam.time_s;
    is_gathering_ = true;
    turned_deg_ = 0;
    strays_.clear();
    last_shaft_deg_ = beam.shaft_deg;
    now_.beams.push_back(beam);
}

void RevolutionBuilder::keep(const RplidarBeam& beam)
{
    if (now_.beams.size() >= kMostBeams) return forget();
    strays_.clear();
    turned_deg_ += step_deg(last_shaft_deg_, beam.shaft_deg);
    last_shaft_deg_ = beam.shaft_deg;
    now_.beams.push_back(beam);
}
}  // namespace rtob

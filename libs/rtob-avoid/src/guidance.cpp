// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/avoid/fast_bearing.h>
#include <rtob/avoid/guidance.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr double kStep_rad = 0.03;
// Ways keep this much more than what is demanded, so that what is found can be flown with noise.
constexpr double kSpare_m = 0.03;
// A bend must bring this share of the lookahead, or it is not worth it; changing the side costs
// more: it must be clearly better.
constexpr double kGain = 0.05;
constexpr double kOtherSide = 0.15;
}  // namespace

Guidance::Guidance(const GuardOptions& options) : lookahead_m_(options.lookahead_m)
{
    const auto steps = static_cast<int>(options.guide_deg * kPi / 180 / kStep_rad);
    for (int i = -steps; i <= steps; ++i)
    {
        const double bend_rad = i * kStep_rad;
        ways_.push_back({bend_rad, std::cos(bend_rad), std::sin(bend_rad), 0});
    }
}

void Guidance::sortIntoSectors(const NearObstacles& obstacles)
{
    nearest_.fill({0, 0, 0, lookahead_m_});
    for (const NearObstacle& obstacle : obstacles)
    {
        const double x = obstacle.place_vehicle.x(), y = obstacle.place_vehicle.y();
        const double gap_m = std::sqrt(x * x + y * y) - obstacle.keep_m;
        if (gap_m >= lookahead_m_) continue;
        const int sector = sector_of(static_cast<float>(x), static_cast<float>(y), kSectors);
        Nearest& nearest = nearest_[static_cast<std::size_t>(sector)];
        if (gap_m < nearest.gap_m) nearest = {x, y, obstacle.keep_m, gap_m};
    }
}

void Guidance::measureWays(double wish_bearing_rad)
{
    for (Way& way : ways_) way.free_m = lookahead_m_;
    const double c = std::cos(wish_bearing_rad), s = std::sin(wish_bearing_rad);
    for (const Nearest& there : nearest_)
        if (there.gap_m < lookahead_m_)
            shorten(c * there.x + s * there.y, c * there.y - s * there.x, there.keep_m + kSpare_m);
}

/// Ends the ways where they come too near to an obstacle, seen along the wish.
void Guidance::shorten(double ahead_m, double left_m, double keep_m)
{
    const double distance2 = ahead_m * ahead_m + left_m * left_m;
    // The ways that pass it at keep_m on either side.
    const double bearing_rad = std::atan2(left_m, ahead_m);
    const double distance_m = std::sqrt(distance2);
    const double half_rad = distance_m > keep_m ? std::asin(keep_m / distance_m) : kPi / 2;
    const auto straight = static_cast<int>(ways_.size() / 2);
    const auto last_way = static_cast<int>(ways_.size()) - 1;
    const auto way_at = [&](double bend_rad)
    { return straight + static_cast<int>(std::lround(bend_rad / kStep_rad)); };
    const int first = std::max(way_at(bearing_rad - half_rad), 0);
    const int last = std::min(way_at(bearing_rad + half_rad), last_way);
    for (int i = first; i <= last; ++i)
    {
        Way& way = ways_[static_cast<std::size_t>(i)];
        const double along_m = way.cos_bend * ahead_m + way.sin_bend * left_m;
        const double aside2 = distance2 - along_m * along_m;
        if (along_m <= 0 || aside2 >= keep_m * keep_m) continue;
        const double free_m = along_m - std::sqrt(keep_m * keep_m - aside2);
        way.free_m = std::min(way.free_m, std::max(free_m, 0.0));
    }
}

double Guidance::worth(const Way& way) const
{
    const bool is_other_side = way.bend_rad * side_ < 0;
    return way.free_m * way.cos_bend - (is_other_side ? kOtherSide * lookahead_m_ : 0);
}

/// Of ways that are worth the same, the straighter one.
double Guidance::choose()
{
    const std::size_t straight = ways_.size() / 2;
    double best_m = worth(ways_[straight]) + kGain * lookahead_m_, best_rad = 0;
    for (std::size_t i = 1; i <= straight; ++i)
        for (const Way& way : {ways_[straight + i], ways_[straight - i]})
        {
            if (worth(way) <= best_m) continue;
            best_m = worth(way);
            best_rad = way.bend_rad;
        }
    if (best_rad != 0) side_ = best_rad > 0 ? 1 : -1;
    return best_rad;
}
}  // namespace rtob

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
constexpr float kSpare_m = 0.03F;
// A bend must bring this share of the lookahead, or it is not worth it; changing the side costs
// more: it must be clearly better.
constexpr float kGain = 0.05F;
constexpr float kOtherSide = 0.15F;
}  // namespace

Guidance::Guidance(const GuardOptions& options)
    : lookahead_m_(static_cast<float>(options.lookahead_m))
{
    const auto steps = static_cast<int>(options.guide_deg * kPi / 180 / kStep_rad);
    for (int i = -steps; i <= steps; ++i)
    {
        bend_rad_.push_back(i * kStep_rad);
        cos_bend_.push_back(static_cast<float>(std::cos(i * kStep_rad)));
        sin_bend_.push_back(static_cast<float>(std::sin(i * kStep_rad)));
    }
    free_m_.resize(bend_rad_.size());
}

void Guidance::sortIntoSectors(const NearObstacles& obstacles)
{
    nearest_.fill({0, 0, 0, lookahead_m_});
    // In portions that the cache holds, first the numbers of all, several at a time.
    constexpr std::size_t kPortion = NearObstacles::kPortion;
    std::array<int, kPortion> sector;
    std::array<float, kPortion> gap_m;
    for (std::size_t begin = 0; begin < obstacles.size(); begin += kPortion)
    {
        const std::size_t count = std::min(kPortion, obstacles.size() - begin);
        const float *x = obstacles.x() + begin, *y = obstacles.y() + begin;
        const float* keep_m = obstacles.keep() + begin;
        for (std::size_t i = 0; i < count; ++i)
        {
            sector[i] = square_sector_of(x[i], y[i], kSectors);
            gap_m[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]) - keep_m[i];
        }
        for (std::size_t i = 0; i < count; ++i)
        {
            Nearest& nearest = nearest_[static_cast<std::size_t>(sector[i])];
            if (gap_m[i] < nearest.gap_m) nearest = {x[i], y[i], keep_m[i], gap_m[i]};
        }
    }
}

void Guidance::measureWays(double wish_bearing_rad)
{
    std::fill(free_m_.begin(), free_m_.end(), lookahead_m_);
    const auto c = static_cast<float>(std::cos(wish_bearing_rad));
    const auto s = static_cast<float>(std::sin(wish_bearing_rad));
    for (const Nearest& there : nearest_)
        if (there.gap_m < lookahead_m_)
            shorten(c * there.x + s * there.y, c * there.y - s * there.x, there.keep_m + kSpare_m);
}

/// Ends the ways where they come too near to an obstacle, seen along the wish.
void Guidance::shorten(float ahead_m, float left_m, float keep_m)
{
    const float distance2 = ahead_m * ahead_m + left_m * left_m, keep2 = keep_m * keep_m;
    // The ways that pass it at keep_m on either side, and one more for rounding.
    const float half_turns =
        distance2 > keep2 ? turns_of(std::sqrt(distance2 - keep2), keep_m) : 0.25F;
    const float turns = turns_of(ahead_m, left_m);
    const float middle = turns > 0.5F ? turns - 1 : turns;
    constexpr auto kWaysATurn = static_cast<float>(2 * kPi / kStep_rad);
    const auto count = static_cast<int>(free_m_.size());
    const auto way_at = [&](float at_turns)
    { return static_cast<int>(at_turns * kWaysATurn + static_cast<float>(count / 2)); };
    const int first = std::max(way_at(middle - half_turns) - 1, 0);
    const int end = std::min(way_at(middle + half_turns) + 2, count);
    const float *cos_bend = cos_bend_.data(), *sin_bend = sin_bend_.data();
    float* free_m = free_m_.data();
    // Up to the chord that the way cuts out of the disc around the obstacle. No branch, so that
    // several ways are taken at a time.
    for (int i = first; i < end; ++i)
    {
        const float along_m = cos_bend[i] * ahead_m + sin_bend[i] * left_m;
        const float half_chord2 = keep2 - (distance2 - along_m * along_m);
        const float to_disc_m = std::max(along_m - std::sqrt(std::max(half_chord2, 0.0F)), 0.0F);
        const bool is_met = along_m > 0 && half_chord2 > 0;
        free_m[i] = is_met ? std::min(free_m[i], to_disc_m) : free_m[i];
    }
}

float Guidance::worth(std::size_t way) const
{
    const bool is_other_side = bend_rad_[way] * side_ < 0;
    return free_m_[way] * cos_bend_[way] - (is_other_side ? kOtherSide * lookahead_m_ : 0);
}

/// Of ways that are worth the same, the straighter one.
double Guidance::choose()
{
    const std::size_t straight = bend_rad_.size() / 2;
    float best_m = worth(straight) + kGain * lookahead_m_;
    double best_rad = 0;
    for (std::size_t i = 1; i <= straight; ++i)
        for (const std::size_t way : {straight + i, straight - i})
        {
            if (worth(way) <= best_m) continue;
            best_m = worth(way);
            best_rad = bend_rad_[way];
        }
    if (best_rad != 0) side_ = best_rad > 0 ? 1 : -1;
    return best_rad;
}
}  // namespace rtob

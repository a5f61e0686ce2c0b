// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <rtob/core/option_checks.h>
#include <rtob/drivers/pilot_stick.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rtob
{
namespace
{
/// Each from -1 to 1.
struct Deflection
{
    double ahead = 0, right = 0, turn_right = 0;
};

/// 1000 to 2000 us are -1 to 1; what is no such pulse is the middle.
double deflection_of(std::uint16_t pulse_us)
{
    if (pulse_us < 800 || pulse_us > 2200) return 0;
    return std::clamp((pulse_us - 1500.0) / 500.0, -1.0, 1.0);
}

double channel_of(const mavlink::RcChannels& rc, int channel)
{
    const double value = deflection_of(rc.chan[static_cast<std::size_t>(std::abs(channel)) - 1]);
    return channel < 0 ? -value : value;
}

/// -1000 to 1000; the protocol's mark for an axis that is not there is the middle.
double axis_of(std::int16_t value)
{
    return value < -1000 || value > 1000 ? 0 : value / 1000.0;
}

std::optional<Deflection> deflection_of(
    const AutopilotNews& news, const StickOptions& options, double now_s)
{
    if (options.source == StickSource::ManualControl)
    {
        if (!news.manual.isYoungerThan(options.max_age_s, now_s)) return std::nullopt;
        const auto& manual = news.manual.message;
        return Deflection{axis_of(manual.x), axis_of(manual.y), axis_of(manual.r)};
    }
    if (!news.rc.isYoungerThan(options.max_age_s, now_s)) return std::nullopt;
    const auto& rc = news.rc.message;
    return Deflection{
        channel_of(rc, options.ahead_channel), channel_of(rc, options.right_channel),
        channel_of(rc, options.turn_right_channel)};
}

/// From 0 at the dead band's edge to 1.
double beyond_dead_band(double length, double dead_band)
{
    return std::clamp((length - dead_band) / (1 - dead_band), 0.0, 1.0);
}

void require_channel(int channel, const char* key)
{
    require(
        std::abs(channel) >= 1 && std::abs(channel) <= 18, key, channel, "1 to 18, or -1 to -18");
}
}  // namespace

void StickOptions::validate() const
{
    require(dead_band >= 0 && dead_band <= 0.5, "dead_band", dead_band, "in [0, 0.5]");
    require(
        max_speed_mps > 0 && max_speed_mps <= 20, "max_speed_mps", max_speed_mps,
        "> 0 and at most 20");
    require(max_turn_dps >= 0 && max_turn_dps <= 180, "max_turn_dps", max_turn_dps, "0 to 180");
    require(max_age_s >= 0.1 && max_age_s <= 2, "max_age_s", max_age_s, "0.1 to 2");
    require_channel(ahead_channel, "ahead_channel");
    require_channel(right_channel, "right_channel");
    require_channel(turn_right_channel, "turn_right_channel");
}

std::optional<PilotWish> pilot_wish(
    const AutopilotNews& news, const StickOptions& options, double now_s)
{
    const auto stick = deflection_of(news, options, now_s);
    if (!stick) return std::nullopt;
    PilotWish wish;
    // The dead band is round: a stick between two axes begins to count where one on an axis does.
    const Eigen::Vector2d way(stick->ahead, -stick->right);
    const double length = way.norm();
    if (length > options.dead_band)
        wish.velocity_vehicle =
            way / length * options.max_speed_mps * beyond_dead_band(length, options.dead_band);
    const double turn = beyond_dead_band(std::abs(stick->turn_right), options.dead_band);
    wish.yaw_rate_radps =
        -std::copysign(turn, stick->turn_right) * mrpt::DEG2RAD(options.max_turn_dps);
    return wish;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/autopilot_news.h>
#include <Eigen/Core>

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace rtob
{
/// Which message carries the pilot's sticks.
enum class StickSource
{
    ManualControl,
    RcChannels
};

constexpr auto enum_names(StickSource)
{
    return std::array<std::pair<StickSource, std::string_view>, 2>{
        {{StickSource::ManualControl, "manual_control"}, {StickSource::RcChannels, "rc_channels"}}};
}

/// [Stick]
struct StickOptions
{
    StickSource source = StickSource::ManualControl;
    double dead_band = 0.1;
    double max_speed_mps = 1.0;
    double max_turn_dps = 45;
    double max_age_s = 0.5;
    int ahead_channel = -2;
    int right_channel = 1;
    int turn_right_channel = 4;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("source", s.source, "a joystick's MANUAL_CONTROL or a receiver's RC_CHANNELS");
        visit("dead_band", s.dead_band, "share of the stick's way that means nothing; [0, 0.5]");
        visit("max_speed_mps", s.max_speed_mps, "that a whole deflection wishes; > 0, at most 20");
        visit("max_turn_dps", s.max_turn_dps, "that a whole deflection turns; 0 to 180");
        visit("max_age_s", s.max_age_s, "older sticks wish nothing; 0.1 to 2");
        visit(
            "ahead_channel", s.ahead_channel,
            "of RC_CHANNELS, 1 to 18; negative: reversed, as pitch is");
        visit("right_channel", s.right_channel, "the same for the way to the right");
        visit("turn_right_channel", s.turn_right_channel, "the same for the turn to the right");
    }
    void validate() const;
};

/// What the pilot wants, in the vehicle's axes.
struct PilotWish
{
    Eigen::Vector2d velocity_vehicle = Eigen::Vector2d::Zero();  ///< m/s, ahead and left
    double yaw_rate_radps = 0;                                   ///< counter-clockwise
};

/// Nothing where there are no sticks, or old ones.
[[nodiscard]] std::optional<PilotWish> pilot_wish(
    const AutopilotNews& news, const StickOptions& options, double now_s);
}  // namespace rtob

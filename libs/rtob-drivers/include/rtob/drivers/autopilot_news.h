// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/mavlink_messages.h>

#include <cmath>

namespace rtob
{
/// The newest message of a kind.
template <class Message>
struct Heard
{
    Message message;
    double time_s = -1e9;  ///< when it came, UNIX time

    /// What comes from the future, because the clock was set back, is not young.
    [[nodiscard]] bool isYoungerThan(double age_s, double now_s) const
    {
        return std::abs(now_s - time_s) < age_s;
    }
};

/// What the flight controller last said of its pilot and of its motion.
struct AutopilotNews
{
    Heard<mavlink::ManualControl> manual;
    Heard<mavlink::RcChannels> rc;
    Heard<mavlink::Attitude> attitude;
    Heard<mavlink::LocalPositionNed> position;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/capsule_reader.h>

#include <algorithm>

namespace rtob
{
namespace
{
constexpr double kLong_s = 1e9;
}  // namespace

void CapsuleReader::forget()
{
    previous_.clear();
    stamps_.forget();
}

std::vector<RplidarBeam> CapsuleReader::read(ByteView packet, double sent_s)
{
    std::vector<RplidarBeam> beams;
    if (begins_stream(packet)) forget();
    if (!previous_.empty())
    {
        double turn_deg = packet_shaft_deg(packet) - packet_shaft_deg(previous_);
        if (turn_deg < 0) turn_deg += 360;
        if (isJump(turn_deg))
        {
            ++jumps_;
            stamps_.forget();
        }
        else
            beams = read_packet(type_, previous_, packet, turn_deg);
    }
    sent_s = stamps_.sent(sent_s);
    stampBeams(beams, sent_s);
    has_last_shaft_ = !beams.empty();
    if (has_last_shaft_) last_shaft_deg_ = beams.back().shaft_deg;
    previous_took_s_ = previous_.empty() ? kLong_s : sent_s - previous_sent_s_;
    previous_.assign(packet.data, packet.data + packet.size);
    previous_sent_s_ = sent_s;
    return beams;
}

/// A packet that was lost whole leaves no trace but a wide turn; the head's speed changes slowly.
bool CapsuleReader::isJump(double turn_deg)
{
    constexpr double change = 1.5, slack_deg = 1;
    const bool is_jump = usual_turn_deg_ > 0 && turn_deg > change * usual_turn_deg_ + slack_deg;
    // After a jump the next packet decides anew: the speed may have changed after all.
    usual_turn_deg_ = is_jump ? 0 : turn_deg;
    return is_jump;
}

/// Beams are taken at a steady rate, the last of a packet just before the packet is sent. A packet
/// that was late makes one of the times beside it too long.
void CapsuleReader::stampBeams(std::vector<RplidarBeam>& beams, double sent_s) const
{
    const auto count = static_cast<double>(beams.size());
    const double step_s = std::min(sent_s - previous_sent_s_, previous_took_s_) / count;
    for (std::size_t i = 0; i < beams.size(); ++i)
    {
        RplidarBeam& beam = beams[i];
        beam.time_s = previous_sent_s_ - step_s * (count - 1 - static_cast<double>(i));
        const double before_deg = i > 0 ? beams[i - 1].shaft_deg : last_shaft_deg_;
        beam.starts = (i > 0 || has_last_shaft_) && beam.shaft_deg < before_deg - 180;
    }
}
}  // namespace rtob

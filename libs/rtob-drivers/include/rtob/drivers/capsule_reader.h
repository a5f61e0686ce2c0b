// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/rplidar_packets.h>
#include <rtob/drivers/steady_stamps.h>

#include <vector>

namespace rtob
{
/// Turns the packets of an Express, Dense or Ultra scan into beams: a packet's beams are known when
/// the next one is there, as the angle between the two is shared out among them.
class CapsuleReader
{
 public:
    /// @param period_s between two packets; 0: not known
    explicit CapsuleReader(RplidarAnswer type, double period_s = 0) : type_(type), stamps_(period_s)
    {
    }

    /// The beams of the packet before this one; none where that is missing.
    /// @param sent_s when the device began to send the packet, just after its last beam, as far as
    /// its arrival tells
    [[nodiscard]] std::vector<RplidarBeam> read(ByteView packet, double sent_s);

    /// Packets were lost: the last one leads nowhere.
    void forget();

    /// Packets that were left out since the one before them was missing, though none was damaged.
    [[nodiscard]] std::uint64_t jumps() const { return jumps_; }

 private:
    [[nodiscard]] bool isJump(double turn_deg);
    void stampBeams(std::vector<RplidarBeam>& beams, double sent_s) const;

    RplidarAnswer type_;
    SteadyStamps stamps_;
    Bytes previous_;
    double previous_sent_s_ = 0;
    double previous_took_s_ = 0;  ///< since the one before it
    double usual_turn_deg_ = 0;   ///< between two packets; 0: not known yet
    double last_shaft_deg_ = 0;   ///< of the last beam that was given out
    bool has_last_shaft_ = false;
    std::uint64_t jumps_ = 0;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/capsule_reader.h>
#include <rtob/drivers/revolution_builder.h>
#include <rtob/drivers/steady_stamps.h>

#include <deque>
#include <optional>

namespace rtob
{
struct RplidarCounters
{
    std::uint64_t revolutions = 0, partial_revolutions = 0;
    std::uint64_t packets = 0;        ///< of scans, intact
    std::uint64_t bytes_skipped = 0;  ///< belong to no packet: noise, or a damaged one's
    std::uint64_t stray_beams = 0, packets_missed = 0;
};

/// Reads what an RPLidar sends: bytes in, replies and whole revolutions out. No input or output of
/// its own, and no clock: the caller says when bytes came.
class RplidarParser
{
 public:
    /// @param byte_s the time a byte takes on the wire; 0 where it takes none
    explicit RplidarParser(double byte_s = 0, double max_gap_deg = 10);

    /// @param arrival_s when the last of these bytes was there
    void push(ByteView bytes, double arrival_s);

    /// A request was sent: only a descriptor counts now, and what comes before it is of the past.
    void expectReply();

    /// How long a beam takes in the scan that is to come, as the device says; 0: not known.
    void setSampleTime(double sample_s) { sample_s_ = sample_s; }

    [[nodiscard]] std::optional<RplidarReply> takeReply();
    [[nodiscard]] std::optional<RplidarRevolution> takeRevolution();
    [[nodiscard]] RplidarCounters counters() const;

 private:
    [[nodiscard]] bool step();
    [[nodiscard]] bool findDescriptor();
    [[nodiscard]] bool readReply();
    [[nodiscard]] bool readPacket();
    void addBeams(ByteView packet);
    void addBeam(const RplidarBeam& beam);
    [[nodiscard]] double sentAt(std::size_t offset) const;
    void skipByte();
    void consume(std::size_t count);

    double byte_s_;
    Bytes bytes_;  ///< that came and are not used yet, from first_ on
    std::size_t first_ = 0;
    double arrival_s_ = 0;  ///< of the last of them
    std::optional<RplidarDescriptor> descriptor_;
    double sample_s_ = 0;
    SteadyStamps stamps_;  ///< of a standard scan's beams
    double last_shaft_deg_ = 0;
    CapsuleReader capsules_{RplidarAnswer::Express};
    RevolutionBuilder builder_;
    std::deque<RplidarReply> replies_;
    std::deque<RplidarRevolution> revolutions_;
    std::uint64_t packets_ = 0, bytes_skipped_ = 0, packets_missed_ = 0;
};
}  // namespace rtob

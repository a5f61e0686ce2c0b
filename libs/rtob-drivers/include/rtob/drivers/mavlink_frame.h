// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/byte_view.h>

#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>

/// MAVLink 2 frames: FD, payload length, two flags, sequence, system, component, id (3 bytes),
/// payload, checksum (2 bytes).
namespace rtob
{
/// CRC-16/MCRF4XX, which MAVLink calls X.25.
class MavlinkCrc
{
 public:
    void add(std::uint8_t byte);
    void add(ByteView bytes);
    void add(std::string_view text);
    [[nodiscard]] std::uint16_t value() const { return value_; }

 private:
    std::uint16_t value_ = 0xFFFF;
};

struct MavlinkFrame
{
    std::uint32_t id = 0;
    std::uint8_t sequence = 0, system = 0, component = 0;
    Bytes payload;  ///< zeros at its end may be missing
};

/// Cuts zeros off the payload's end, as the protocol wants, and adds header and checksum.
/// @param crc_extra of this kind of message: both ends must mean the same by it
[[nodiscard]] Bytes encode_frame(const MavlinkFrame& frame, std::uint8_t crc_extra);

struct MavlinkCounters
{
    std::uint64_t frames = 0;         ///< intact, of a known kind
    std::uint64_t unknown = 0;        ///< frames of a kind that is not read here
    std::uint64_t damaged = 0;        ///< frames with a wrong checksum
    std::uint64_t bytes_skipped = 0;  ///< between frames
    std::uint64_t lost = 0;           ///< frames that the sequence numbers miss
};

/// Finds the frames in a stream of bytes, or in datagrams.
class MavlinkReader
{
 public:
    void push(ByteView bytes);
    /// The next intact frame of a known kind.
    [[nodiscard]] std::optional<MavlinkFrame> take();
    [[nodiscard]] const MavlinkCounters& counters() const { return counters_; }

 private:
    [[nodiscard]] bool step();
    void countLost(const MavlinkFrame& frame);

    Bytes bytes_;
    std::size_t first_ = 0;
    std::deque<MavlinkFrame> frames_;
    MavlinkCounters counters_;
    std::optional<std::uint8_t> last_sequence_;
    std::uint16_t last_sender_ = 0;
};
}  // namespace rtob

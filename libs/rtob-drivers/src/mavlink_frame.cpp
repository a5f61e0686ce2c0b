// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/mavlink_codec.h>
#include <rtob/drivers/mavlink_frame.h>

#include <map>

namespace rtob
{
namespace
{
constexpr std::uint8_t kStart = 0xFD;
constexpr std::size_t kHeader_bytes = 10, kChecksum_bytes = 2, kSignature_bytes = 13;
constexpr std::uint8_t kIsSigned = 0x01;
constexpr std::size_t kMostWaiting = 256;

struct Kind
{
    std::uint8_t crc_extra = 0;
    std::size_t longest = 0;
};

const std::map<std::uint32_t, Kind>& known_kinds()
{
    static const auto kinds = []
    {
        std::map<std::uint32_t, Kind> table;
        mavlink::for_each_message(
            [&](const auto& message)
            {
                using Message = std::decay_t<decltype(message)>;
                table[Message::id] = {
                    mavlink::crc_extra<Message>(), mavlink::full_length<Message>()};
            });
        return table;
    }();
    return kinds;
}

std::uint16_t checksum_of(ByteView frame, std::size_t payload_bytes, std::uint8_t crc_extra)
{
    MavlinkCrc crc;
    crc.add(frame.from(1).first(kHeader_bytes - 1 + payload_bytes));
    crc.add(crc_extra);
    return crc.value();
}
}  // namespace

void MavlinkCrc::add(std::uint8_t byte)
{
    auto mixed = static_cast<std::uint8_t>(byte ^ (value_ & 0xFF));
    mixed = static_cast<std::uint8_t>(mixed ^ (mixed << 4));
    value_ = static_cast<std::uint16_t>((value_ >> 8) ^ (mixed << 8) ^ (mixed << 3) ^ (mixed >> 4));
}

void MavlinkCrc::add(ByteView bytes)
{
    for (std::size_t i = 0; i < bytes.size; ++i) add(bytes[i]);
}

void MavlinkCrc::add(std::string_view text)
{
    for (const char letter : text) add(static_cast<std::uint8_t>(letter));
}

Bytes encode_frame(const MavlinkFrame& frame, std::uint8_t crc_extra)
{
    std::size_t length = frame.payload.size();
    while (length > 1 && frame.payload[length - 1] == 0) --length;
    Bytes bytes{
        kStart,
        static_cast<std::uint8_t>(length),
        0,
        0,
        frame.sequence,
        frame.system,
        frame.component,
        static_cast<std::uint8_t>(frame.id),
        static_cast<std::uint8_t>(frame.id >> 8),
        static_cast<std::uint8_t>(frame.id >> 16)};
    for (std::size_t i = 0; i < length; ++i) bytes.push_back(frame.payload[i]);
    append_u16(bytes, checksum_of(bytes, length, crc_extra));
    return bytes;
}

void MavlinkReader::push(ByteView bytes)
{
    bytes_.insert(bytes_.end(), bytes.data, bytes.data + bytes.size);
    while (step())
    {
    }
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(first_));
    first_ = 0;
}

std::optional<MavlinkFrame> MavlinkReader::take()
{
    if (frames_.empty()) return std::nullopt;
    MavlinkFrame frame = std::move(frames_.front());
    frames_.pop_front();
    return frame;
}

bool MavlinkReader::step()
{
    const ByteView rest = ByteView(bytes_).from(first_);
    if (rest.size == 0) return false;
    const auto skip = [this](std::size_t count) { first_ += count; };
    if (rest[0] != kStart)
    {
        ++counters_.bytes_skipped;
        skip(1);
        return true;
    }
    if (rest.size < kHeader_bytes) return false;
    const std::size_t payload_bytes = rest[1];
    const bool is_signed = (rest[2] & kIsSigned) != 0;
    const std::size_t length =
        kHeader_bytes + payload_bytes + kChecksum_bytes + (is_signed ? kSignature_bytes : 0);
    if (rest.size < length) return false;
    MavlinkFrame frame;
    frame.id = rest[7] | (static_cast<std::uint32_t>(rest[8]) << 8) |
               (static_cast<std::uint32_t>(rest[9]) << 16);
    const auto kind = known_kinds().find(frame.id);
    if (kind == known_kinds().end())
    {
        // Without its crc_extra nobody can tell whether it is intact. Its length is believed where
        // a frame follows, or nothing yet.
        ++counters_.unknown;
        skip(rest.size == length || rest[length] == kStart ? length : 1);
        return true;
    }
    const std::uint16_t checksum = u16_at(rest, kHeader_bytes + payload_bytes);
    if (checksum != checksum_of(rest, payload_bytes, kind->second.crc_extra))
    {
        ++counters_.damaged;
        skip(1);
        return true;
    }
    frame.sequence = rest[4];
    frame.system = rest[5];
    frame.component = rest[6];
    const std::size_t understood = std::min(payload_bytes, kind->second.longest);
    frame.payload.assign(rest.data + kHeader_bytes, rest.data + kHeader_bytes + understood);
    ++counters_.frames;
    countLost(frame);
    if (frames_.size() >= kMostWaiting) frames_.pop_front();
    frames_.push_back(std::move(frame));
    skip(length);
    return true;
}

void MavlinkReader::countLost(const MavlinkFrame& frame)
{
    const auto sender = static_cast<std::uint16_t>((frame.system << 8) | frame.component);
    if (last_sequence_ && sender == last_sender_)
        counters_.lost += static_cast<std::uint8_t>(frame.sequence - *last_sequence_ - 1);
    last_sequence_ = frame.sequence;
    last_sender_ = sender;
}
}  // namespace rtob

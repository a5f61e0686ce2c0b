// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/mavlink_frame.h>
#include <rtob/drivers/mavlink_messages.h>

#include <algorithm>
#include <cstring>
#include <type_traits>

/// Messages to payloads and back, from the messages' own lists of fields.
namespace rtob::mavlink
{
namespace detail
{
template <class Value>
struct Array : std::false_type
{
};
template <class Item, std::size_t count>
struct Array<std::array<Item, count>> : std::true_type
{
};

template <class Value>
constexpr const char* type_name()
{
    if constexpr (std::is_same_v<Value, char>) return "char";
    if constexpr (std::is_same_v<Value, float>) return "float";
    if constexpr (std::is_same_v<Value, std::int8_t>) return "int8_t";
    if constexpr (std::is_same_v<Value, std::uint8_t>) return "uint8_t";
    if constexpr (std::is_same_v<Value, std::int16_t>) return "int16_t";
    if constexpr (std::is_same_v<Value, std::uint16_t>) return "uint16_t";
    if constexpr (std::is_same_v<Value, std::uint32_t>) return "uint32_t";
    if constexpr (std::is_same_v<Value, std::int64_t>) return "int64_t";
    if constexpr (std::is_same_v<Value, std::uint64_t>) return "uint64_t";
}

/// The wire is little-endian; so are all processors that Debian's MRPT runs on (checked below).
struct Pack
{
    Bytes bytes;

    template <class Value>
    void operator()(const char*, const Value& value)
    {
        const std::size_t at = bytes.size();
        bytes.resize(at + sizeof(Value));
        std::memcpy(bytes.data() + at, &value, sizeof(Value));
    }
    void extension() {}
};

/// What is missing at the payload's end is zero.
struct Unpack
{
    ByteView payload;
    std::size_t at = 0;

    template <class Value>
    void operator()(const char*, Value& value)
    {
        std::array<std::uint8_t, sizeof(Value)> bytes{};
        for (std::size_t i = 0; i < bytes.size(); ++i, ++at)
            bytes[i] = at < payload.size ? payload[at] : std::uint8_t{0};
        std::memcpy(&value, bytes.data(), sizeof(Value));
    }
    void extension() {}
};

struct Measure
{
    MavlinkCrc crc;
    std::size_t length = 0, base_length = 0;
    bool is_extension = false;

    template <class Value>
    void operator()(const char* name, const Value&)
    {
        length += sizeof(Value);
        if (is_extension) return;
        base_length = length;
        if constexpr (Array<Value>::value)
        {
            crc.add(std::string_view(type_name<typename Value::value_type>()));
            addName(name);
            crc.add(static_cast<std::uint8_t>(std::tuple_size_v<Value>));
        }
        else
        {
            crc.add(std::string_view(type_name<Value>()));
            addName(name);
        }
    }
    void addName(const char* name)
    {
        crc.add(std::string_view(" "));
        crc.add(std::string_view(name));
        crc.add(std::string_view(" "));
    }
    void extension() { is_extension = true; }
};

template <class Message>
Measure measure()
{
    Measure measure;
    measure.crc.add(std::string_view(Message::name));
    measure.crc.add(std::string_view(" "));
    const Message message;
    Message::fields(message, measure);
    return measure;
}
}  // namespace detail

#if __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "MAVLink payloads are packed as little-endian memory"
#endif

/// The byte that both ends mix into the checksum, so that only equal messages are understood.
template <class Message>
[[nodiscard]] std::uint8_t crc_extra()
{
    static const std::uint16_t crc = detail::measure<Message>().crc.value();
    return static_cast<std::uint8_t>((crc & 0xFF) ^ (crc >> 8));
}
/// In bytes; without the later additions, and with them.
template <class Message>
[[nodiscard]] std::size_t base_length()
{
    return detail::measure<Message>().base_length;
}
template <class Message>
[[nodiscard]] std::size_t full_length()
{
    return detail::measure<Message>().length;
}

template <class Message>
[[nodiscard]] Bytes pack(const Message& message)
{
    detail::Pack pack;
    Message::fields(message, pack);
    return pack.bytes;
}

template <class Message>
[[nodiscard]] Message unpack(ByteView payload)
{
    Message message;
    detail::Unpack unpack{payload};
    Message::fields(message, unpack);
    return message;
}

/// The message of a frame, where it is of this kind.
template <class Message>
[[nodiscard]] std::optional<Message> message_of(const MavlinkFrame& frame)
{
    if (frame.id != Message::id) return std::nullopt;
    return unpack<Message>(frame.payload);
}

/// Who sends, and how many frames so far.
struct Sender
{
    std::uint8_t system = 1, component = 197;  ///< a part of the vehicle: visual odometry
    std::uint8_t sequence = 0;

    template <class Message>
    [[nodiscard]] Bytes encode(const Message& message)
    {
        return encode_frame(
            {Message::id, sequence++, system, component, pack(message)}, crc_extra<Message>());
    }
};
}  // namespace rtob::mavlink

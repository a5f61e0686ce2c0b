// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtob
{
using Bytes = std::vector<std::uint8_t>;

/// Bytes that someone else owns.
struct ByteView
{
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;

    ByteView() = default;
    ByteView(const std::uint8_t* first, std::size_t count) : data(first), size(count) {}
    ByteView(const Bytes& bytes) : data(bytes.data()), size(bytes.size()) {}

    [[nodiscard]] std::uint8_t operator[](std::size_t i) const { return data[i]; }
    [[nodiscard]] ByteView from(std::size_t first) const { return {data + first, size - first}; }
    [[nodiscard]] ByteView first(std::size_t count) const { return {data, count}; }
};

/// Little-endian integers, as RPLidar and MAVLink send them.
[[nodiscard]] inline std::uint16_t u16_at(ByteView bytes, std::size_t at)
{
    return static_cast<std::uint16_t>(bytes[at] | (bytes[at + 1] << 8));
}
[[nodiscard]] inline std::uint32_t u32_at(ByteView bytes, std::size_t at)
{
    return u16_at(bytes, at) | (static_cast<std::uint32_t>(u16_at(bytes, at + 2)) << 16);
}

inline void append_u16(Bytes& bytes, std::uint16_t value)
{
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
}
inline void append_u32(Bytes& bytes, std::uint32_t value)
{
    append_u16(bytes, static_cast<std::uint16_t>(value & 0xFFFF));
    append_u16(bytes, static_cast<std::uint16_t>(value >> 16));
}
}  // namespace rtob

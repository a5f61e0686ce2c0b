// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

namespace rtob::devices
{
/// What can happen to a device and its line.
enum class LineFault
{
    Garbage,        ///< bytes that the device never sent
    HalfPacket,     ///< the rest of a packet is lost
    WrongChecksum,  ///< a byte of a packet is changed
    Stall,          ///< nothing comes for a while; what was measured is lost
    Unplug,         ///< the port is gone, and back after a while
    Restart,        ///< the device lost its power for a moment and waits for commands
    ErrorState      ///< the device reports that it is broken, until a reset
};

constexpr std::array<LineFault, 7> all_line_faults{
    LineFault::Garbage, LineFault::HalfPacket, LineFault::WrongChecksum, LineFault::Stall,
    LineFault::Unplug,  LineFault::Restart,    LineFault::ErrorState};
}  // namespace rtob::devices

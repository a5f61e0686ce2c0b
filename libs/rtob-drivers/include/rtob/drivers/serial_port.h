// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/byte_view.h>

#include <chrono>
#include <stdexcept>
#include <string>

namespace rtob
{
/// A port that cannot be opened, or is there no more: what() names it and what to do.
class PortError : public std::runtime_error
{
 public:
    using std::runtime_error::runtime_error;
};

/// A raw serial line, 8N1, at any speed that the hardware can do: MRPT's CSerialPort knows the
/// standard ones only, and RPLidars talk at 256000 and 1000000 baud.
class SerialPort
{
 public:
    /// Throws PortError.
    SerialPort(std::string device, unsigned baud);
    ~SerialPort();
    SerialPort(const SerialPort&) = delete;
    SerialPort& operator=(const SerialPort&) = delete;

    /// Waits until bytes are there and gives what there is; nothing after the timeout. Throws
    /// PortError where the device was unplugged.
    [[nodiscard]] Bytes read(std::chrono::milliseconds timeout);
    /// Throws PortError where the bytes cannot be sent within a second.
    void write(ByteView bytes);
    /// Forgets what has arrived so far.
    void drain();
    /// The line that stops the motor of an RPLidar A1 while set. Devices without it ignore this.
    void setDtr(bool on);

    [[nodiscard]] const std::string& device() const { return device_; }
    [[nodiscard]] unsigned baud() const { return baud_; }

 private:
    [[noreturn]] void fail(const std::string& what) const;
    void configure() const;

    std::string device_;
    unsigned baud_;
    int file_ = -1;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/serial_port.h>

#include <asm/termbits.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace rtob
{
namespace
{
const char* advice(int error)
{
    switch (error)
    {
        case ENOENT:
            return ". Is it plugged in, and is this its name? ls /dev/serial/by-id";
        case EACCES:
            return ". Join the group that may use it (sudo adduser $USER dialout) and log in anew";
        case EBUSY:
            return ". Another program has it: close that one";
        default:
            return "";
    }
}
}  // namespace

SerialPort::SerialPort(std::string device, unsigned baud) : device_(std::move(device)), baud_(baud)
{
    file_ = open(device_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (file_ < 0) fail(std::string("cannot be opened: ") + std::strerror(errno) + advice(errno));
    try
    {
        // A second program on the same line would take half of the bytes.
        if (ioctl(file_, TIOCEXCL) != 0) fail("is no serial line");
        configure();
    }
    catch (...)
    {
        close(file_);
        throw;
    }
}

SerialPort::~SerialPort()
{
    close(file_);
}

void SerialPort::fail(const std::string& what) const
{
    throw PortError("serial port " + device_ + " " + what + ".");
}

void SerialPort::configure() const
{
    termios2 settings{};
    if (ioctl(file_, TCGETS2, &settings) != 0) fail("is no serial line");
    settings.c_iflag = 0;
    settings.c_oflag = 0;
    settings.c_lflag = 0;
    settings.c_cflag = CS8 | CREAD | CLOCAL | BOTHER;
    settings.c_ispeed = baud_;
    settings.c_ospeed = baud_;
    settings.c_cc[VMIN] = 0;
    settings.c_cc[VTIME] = 0;
    if (ioctl(file_, TCSETS2, &settings) != 0)
        fail("cannot do " + std::to_string(baud_) + " baud: " + std::strerror(errno));
}

Bytes SerialPort::read(std::chrono::milliseconds timeout)
{
    pollfd wait{file_, POLLIN, 0};
    const int ready = poll(&wait, 1, static_cast<int>(timeout.count()));
    if (ready < 0 && errno != EINTR) fail(std::string("cannot be read: ") + std::strerror(errno));
    if (ready <= 0) return {};
    std::array<std::uint8_t, 4096> buffer;
    const auto count = ::read(file_, buffer.data(), buffer.size());
    if (count > 0) return Bytes(buffer.data(), buffer.data() + count);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return {};
    fail("was unplugged");
}

void SerialPort::write(ByteView bytes)
{
    constexpr int patience_ms = 1000;
    while (bytes.size > 0)
    {
        pollfd wait{file_, POLLOUT, 0};
        const int ready = poll(&wait, 1, patience_ms);
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) fail("takes no bytes");
        const auto count = ::write(file_, bytes.data, bytes.size);
        if (count < 0 && (errno == EAGAIN || errno == EINTR)) continue;
        if (count < 0) fail(std::string("cannot be written: ") + std::strerror(errno));
        bytes = bytes.from(static_cast<std::size_t>(count));
    }
}

void SerialPort::drain()
{
    ioctl(file_, TCFLSH, TCIFLUSH);
}

void SerialPort::setDtr(bool on)
{
    int line = TIOCM_DTR;
    ioctl(file_, on ? TIOCMBIS : TIOCMBIC, &line);
}
}  // namespace rtob

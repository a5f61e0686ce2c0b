// SPDX-License-Identifier: BSD-3-Clause
#include <asm/termbits.h>
#include <fcntl.h>
#include <poll.h>
#include <rtob/devices/pseudo_terminal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace rtob::devices
{
namespace
{
[[noreturn]] void fail(const std::string& what)
{
    throw std::runtime_error(what + ": " + std::strerror(errno));
}
}  // namespace

PseudoTerminal::PseudoTerminal(std::string link) : link_(std::move(link))
{
    plug();
}

PseudoTerminal::~PseudoTerminal()
{
    unplug();
}

void PseudoTerminal::plug()
{
    if (isPlugged()) return;
    master_ = open("/dev/ptmx", O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (master_ < 0) fail("pseudo-terminal");
    int unlock = 0;
    ioctl(master_, TIOCSPTLCK, &unlock);
    int number = 0;
    if (ioctl(master_, TIOCGPTN, &number) != 0) fail("pseudo-terminal");
    const std::string slave = "/dev/pts/" + std::to_string(number);
    slave_ = open(slave.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (slave_ < 0) fail("pseudo-terminal " + slave);
    termios2 raw{};
    ioctl(slave_, TCGETS2, &raw);
    raw.c_iflag = raw.c_oflag = raw.c_lflag = 0;
    ioctl(slave_, TCSETS2, &raw);
    // Only what such a device left behind makes way.
    if (std::filesystem::is_symlink(link_)) std::filesystem::remove(link_);
    if (symlink(slave.c_str(), link_.c_str()) != 0) fail("link " + link_);
}

void PseudoTerminal::unplug()
{
    if (!isPlugged()) return;
    std::error_code ignored;
    std::filesystem::remove(link_, ignored);
    close(slave_);
    close(master_);
    master_ = slave_ = -1;
}

std::vector<std::uint8_t> PseudoTerminal::receive(int timeout_ms)
{
    pollfd wait{master_, POLLIN, 0};
    if (!isPlugged() || poll(&wait, 1, timeout_ms) <= 0)
    {
        if (!isPlugged()) usleep(static_cast<useconds_t>(1000 * timeout_ms));
        return {};
    }
    std::array<std::uint8_t, 1024> buffer;
    const auto count = read(master_, buffer.data(), buffer.size());
    if (count <= 0) return {};
    return {buffer.data(), buffer.data() + count};
}

void PseudoTerminal::send(const std::vector<std::uint8_t>& bytes)
{
    if (isPlugged() && !bytes.empty() && write(master_, bytes.data(), bytes.size()) < 0 &&
        errno != EAGAIN)
        fail("pseudo-terminal " + link_);
}

unsigned PseudoTerminal::baud() const
{
    termios2 settings{};
    if (!isPlugged() || ioctl(slave_, TCGETS2, &settings) != 0) return 0;
    return settings.c_ospeed;
}
}  // namespace rtob::devices

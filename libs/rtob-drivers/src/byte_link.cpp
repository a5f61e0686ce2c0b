// SPDX-License-Identifier: BSD-3-Clause
#include <arpa/inet.h>
#include <netdb.h>
#include <poll.h>
#include <rtob/drivers/byte_link.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace rtob
{
namespace
{
class SerialLink : public ByteLink
{
 public:
    SerialLink(const std::string& device, unsigned baud) : port_(device, baud) {}
    Bytes read(std::chrono::milliseconds timeout) override { return port_.read(timeout); }
    void write(ByteView bytes) override { port_.write(bytes); }

 private:
    SerialPort port_;
};

class UdpLink : public ByteLink
{
 public:
    /// @param is_server hears at the address; else sends to it
    UdpLink(
        const std::string& link, const std::string& host, const std::string& port, bool is_server)
        : link_(link)
    {
        addrinfo wanted{}, *found = nullptr;
        wanted.ai_family = AF_INET;
        wanted.ai_socktype = SOCK_DGRAM;
        if (const int error = getaddrinfo(host.c_str(), port.c_str(), &wanted, &found))
            throw PortError("link " + link + ": " + gai_strerror(error) + ". Write udp:HOST:PORT.");
        std::memcpy(&peer_, found->ai_addr, sizeof peer_);
        freeaddrinfo(found);
        has_peer_ = !is_server;
        socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        if (socket_ < 0) fail("cannot be opened");
        const auto* address = reinterpret_cast<const sockaddr*>(&peer_);
        if (!is_server || bind(socket_, address, sizeof peer_) == 0) return;
        const int error = errno;
        close(socket_);
        errno = error;
        fail("cannot be bound");
    }
    ~UdpLink() override { close(socket_); }

    Bytes read(std::chrono::milliseconds timeout) override
    {
        pollfd wait{socket_, POLLIN, 0};
        if (poll(&wait, 1, static_cast<int>(timeout.count())) <= 0) return {};
        std::array<std::uint8_t, 65536> buffer;
        sockaddr_in sender{};
        socklen_t size = sizeof sender;
        const auto count = recvfrom(
            socket_, buffer.data(), buffer.size(), 0, reinterpret_cast<sockaddr*>(&sender), &size);
        if (count <= 0) return {};  // also: the other side is not there yet
        peer_ = sender;
        has_peer_ = true;
        return {buffer.data(), buffer.data() + count};
    }

    void write(ByteView bytes) override
    {
        if (!has_peer_ || bytes.size == 0) return;
        static_cast<void>(sendto(
            socket_, bytes.data, bytes.size, 0, reinterpret_cast<const sockaddr*>(&peer_),
            sizeof peer_));
    }

 private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw PortError("link " + link_ + " " + what + ": " + std::strerror(errno) + ".");
    }

    std::string link_;
    int socket_ = -1;
    sockaddr_in peer_{};
    bool has_peer_ = false;
};
}  // namespace

std::unique_ptr<ByteLink> open_link(const std::string& link, unsigned baud)
{
    const auto first = link.find(':');
    const std::string kind = link.substr(0, first);
    if (first == std::string::npos || (kind != "udp" && kind != "udpin"))
        return std::make_unique<SerialLink>(link, baud);
    const auto last = link.rfind(':');
    if (last == first)
        throw PortError("link " + link + ": the port is missing. Write " + kind + ":HOST:PORT.");
    return std::make_unique<UdpLink>(
        link, link.substr(first + 1, last - first - 1), link.substr(last + 1), kind == "udpin");
}
}  // namespace rtob

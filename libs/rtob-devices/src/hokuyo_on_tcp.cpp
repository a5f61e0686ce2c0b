// SPDX-License-Identifier: BSD-3-Clause
#include <arpa/inet.h>
#include <poll.h>
#include <rtob/devices/hokuyo_on_tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace rtob::devices
{
namespace
{
constexpr int kSteps = 1440, kFirst = 0, kLast = 1080, kFront = 540;
constexpr double kTurn_s = 0.025, kMaxRange_m = 30;
constexpr double kPi = 3.14159265358979323846;

double now_s()
{
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

/// The check letter behind each line.
char sum_of(const std::string& text)
{
    unsigned sum = 0;
    for (const char letter : text) sum += static_cast<unsigned char>(letter);
    return static_cast<char>((sum & 0x3F) + 0x30);
}

std::string line(const std::string& text, const std::string& end = "")
{
    return text + end + sum_of(text) + "\n";
}

/// Six bits a letter.
std::string encoded(unsigned value, int letters)
{
    std::string text;
    for (int i = letters - 1; i >= 0; --i)
        text += static_cast<char>(((value >> (6 * i)) & 0x3F) + 0x30);
    return text;
}

void send_all(int client, const std::string& text)
{
    static_cast<void>(send(client, text.data(), text.size(), MSG_NOSIGNAL));
}
}  // namespace

HokuyoOnTcp::HokuyoOnTcp(RangeSource ranges) : ranges_(std::move(ranges))
{
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
        listen(listener_, 1) != 0)
        throw std::runtime_error("emulated Hokuyo: no port");
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { live(); });
}

HokuyoOnTcp::~HokuyoOnTcp()
{
    ends_ = true;
    thread_.join();
    close(listener_);
}

void HokuyoOnTcp::live()
{
    constexpr int step_ms = 20;
    while (!ends_)
    {
        pollfd wait{listener_, POLLIN, 0};
        if (poll(&wait, 1, step_ms) <= 0) continue;
        const int client = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        if (client < 0) continue;
        scan_command_.clear();
        disconnects_ = false;
        serve(client);
        close(client);
    }
}

void HokuyoOnTcp::serve(int client)
{
    std::string received;
    while (!ends_ && !disconnects_)
    {
        pollfd wait{client, POLLIN, 0};
        if (poll(&wait, 1, 1) > 0)
        {
            std::array<char, 256> buffer;
            const auto count = recv(client, buffer.data(), buffer.size(), 0);
            if (count <= 0) return;
            received.append(buffer.data(), static_cast<std::size_t>(count));
        }
        for (auto end = received.find('\n'); end != std::string::npos; end = received.find('\n'))
        {
            answer(client, received.substr(0, end));
            received.erase(0, end + 1);
        }
        if (scan_command_.empty() || now_s() < next_scan_s_ + kTurn_s) continue;
        if (now_s() > silent_until_s_) sendScan(client, next_scan_s_);
        next_scan_s_ = std::max(next_scan_s_ + kTurn_s, now_s() - kTurn_s);
    }
}

void HokuyoOnTcp::answer(int client, const std::string& command)
{
    const std::string kind = command.substr(0, 2);
    if (kind == "QT" || kind == "RS") scan_command_.clear();
    std::string data;
    if (kind == "PP")
        for (const char* text :
             {"MODL:UTM-30LX", "DMIN:23", "DMAX:30000", "ARES:1440", "AMIN:0", "AMAX:1080",
              "AFRT:540", "SCAN:2400"})
            data += line(text, ";");
    if (kind == "VV")
        for (const char* text : {"VEND:emulated", "PROD:UTM-30LX", "FIRM:1", "PROT:SCIP 2.0"})
            data += line(text, ";");
    send_all(client, command + "\n" + line("00") + data + "\n");
    if (kind != "MD") return;
    scan_command_ = command;
    next_scan_s_ = now_s();
}

void HokuyoOnTcp::sendScan(int client, double start_s)
{
    constexpr std::size_t line_letters = 64;
    const auto clock_ms = static_cast<unsigned>(std::llround(1000 * std::fmod(start_s, 16000)));
    std::string ranges;
    for (int step = kFirst; step <= kLast; ++step)
    {
        const double time_s = start_s + kTurn_s * step / kSteps;
        const double range_m = ranges_(2 * kPi * (step - kFront) / kSteps, time_s);
        const bool is_seen = range_m > 0 && range_m < kMaxRange_m;
        ranges += encoded(is_seen ? static_cast<unsigned>(std::lround(1000 * range_m)) : 1U, 3);
    }
    std::string text = scan_command_ + "\n" + line("99") + line(encoded(clock_ms, 4));
    for (std::size_t at = 0; at < ranges.size(); at += line_letters)
        text += line(ranges.substr(at, line_letters));
    send_all(client, text + "\n");
}
}  // namespace rtob::devices

// SPDX-License-Identifier: BSD-3-Clause
#include "state_stream.h"

#include <gmock/gmock.h>

#include "state_listener.h"

namespace rtob
{
namespace
{
ScanReport report_at(double x)
{
    ScanReport report;
    report.stamp_s = 1000.5;
    report.pose_map_vehicle = {x, 2, 0.25};
    report.covariance(0, 2) = -0.125;
    report.state = TrackingState::Degraded;
    return report;
}

TEST(StateLine, HoldsPoseStateAndTiming)
{
    const auto line = state_line({report_at(1), 0.02, 7, 3});
    EXPECT_EQ('\n', line.back());
    const auto json = nlohmann::json::parse(line);
    EXPECT_EQ(1000.5, json["stamp_s"]);
    EXPECT_EQ(1, json["x_m"]);
    EXPECT_EQ(2, json["y_m"]);
    EXPECT_EQ(0.25, json["yaw_rad"]);
    EXPECT_EQ("DEGRADED", json["state"]);
    EXPECT_EQ(-0.125, json["covariance_xx_xy_xa_yy_ya_aa"][2]);
    EXPECT_EQ(20, json["latency_ms"]);
    EXPECT_EQ(7, json["scans"]);
    EXPECT_EQ(3, json["dropped"]);
}

TEST(StateStream, SendsDatagrams)
{
    const test::StateListener listener;
    StateStreamOptions options;
    options.udp_port = static_cast<unsigned>(listener.port());
    StateStream stream(options);
    stream.publish(state_line({report_at(4), 0, 0, 0}));
    while (listener.count() < 1) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(4, listener.states()[0]["x_m"]);
}

/// A TCP client at the loopback address.
class Client
{
 public:
    explicit Client(unsigned port)
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        is_connected_ =
            connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    }
    ~Client() { close(socket_); }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    [[nodiscard]] bool isConnected() const { return is_connected_; }
    [[nodiscard]] std::string readLine()
    {
        std::array<char, 65536> bytes;
        while (received_.find('\n') == std::string::npos)
        {
            const auto count = recv(socket_, bytes.data(), bytes.size(), 0);
            if (count <= 0) return received_;
            received_.append(bytes.data(), static_cast<std::size_t>(count));
        }
        const auto end = received_.find('\n') + 1;
        const std::string line = received_.substr(0, end);
        received_.erase(0, end);
        return line;
    }

 private:
    std::string received_;
    int socket_ = socket(AF_INET, SOCK_STREAM, 0);
    bool is_connected_ = false;
};

/// A port that was free a moment ago.
unsigned free_port()
{
    return static_cast<unsigned>(test::StateListener().port());
}

TEST(StateStream, SendsLinesToWhoConnectsAndWaitsForNobody)
{
    StateStreamOptions options;
    options.tcp_port = free_port();
    StateStream stream(options);
    Client reader(options.tcp_port);
    {
        const Client deaf(options.tcp_port);
        ASSERT_TRUE(reader.isConnected() && deaf.isConnected());
        stream.publish("one\n");
        EXPECT_EQ("one\n", reader.readLine());
        // The deaf one is full at some time; the other one reads on.
        const std::string long_line = std::string(4000, 'x') + "\n";
        for (int i = 0; i < 3000; ++i)
        {
            stream.publish(long_line);
            ASSERT_EQ(long_line, reader.readLine());
        }
    }
    stream.publish("two\n");
    EXPECT_EQ("two\n", reader.readLine());
}

TEST(StateStream, ListensAtTheLoopbackAddressAloneAndOnlyWhereAsked)
{
    const StateStreamOptions options;
    EXPECT_EQ("127.0.0.1", options.udp_host);
    EXPECT_EQ("127.0.0.1", options.tcp_bind);
    EXPECT_EQ(0u, options.udp_port);
    EXPECT_EQ(0u, options.tcp_port);
    StateStream off(options);
    off.publish("nobody hears\n");
}

TEST(StateStream, RefusesWhatIsNoAddressAndAPortInUse)
{
    StateStreamOptions options;
    options.tcp_port = free_port();
    options.tcp_bind = "localhost";
    EXPECT_THROW(StateStream{options}, std::runtime_error);
    options.tcp_bind = "127.0.0.1";
    const StateStream first(options);
    EXPECT_THROW(StateStream{options}, std::runtime_error);
}
}  // namespace
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/rplidar_parser.h>
#include <rtob/drivers/serial_port.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace rtob
{
/// A way to measure that the device offers.
struct RplidarMode
{
    std::uint16_t id = 0;
    std::string name;
    RplidarAnswer type = RplidarAnswer::Standard;
    double sample_s = 0;      ///< between two beams; 0: not told
    double max_range_m = 0;   ///< 0: not told
    bool is_typical = false;  ///< the maker's choice
};

struct RplidarWish
{
    std::string port;
    unsigned baud = 0;          ///< 0: found by trying
    std::string mode = "auto";  ///< auto, standard, express or a name that the device tells
    unsigned motor_rpm = 0;     ///< 0: the device's own speed
    double max_gap_deg = 10;    ///< of a revolution that counts as whole
};

/// A connected RPLidar that is scanning. Every call throws PortError where the line is broken.
class RplidarDevice
{
 public:
    /// Opens the port, asks who is there and how it is, starts the motor and the scan. Throws
    /// PortError that says what failed and what to do.
    explicit RplidarDevice(const RplidarWish& wish);
    /// Stops the scan and the motor, as far as the line still works.
    ~RplidarDevice();
    RplidarDevice(const RplidarDevice&) = delete;
    RplidarDevice& operator=(const RplidarDevice&) = delete;

    /// The whole revolutions that came within the timeout.
    [[nodiscard]] std::vector<RplidarRevolution> read(std::chrono::milliseconds timeout);

    [[nodiscard]] const RplidarInfo& info() const { return info_; }
    [[nodiscard]] const RplidarHealthReport& health() const { return health_; }
    [[nodiscard]] const RplidarMode& mode() const { return mode_; }
    [[nodiscard]] const std::vector<RplidarMode>& modes() const { return modes_; }
    [[nodiscard]] RplidarCounters counters() const { return parser_.counters(); }
    [[nodiscard]] const SerialPort& port() const { return *port_; }

 private:
    void findBaud(const RplidarWish& wish);
    void checkHealth();
    void readModes();
    [[nodiscard]] RplidarMode readMode(std::uint16_t id);
    void chooseMode(const std::string& wanted);
    void startMotor(unsigned rpm);
    void startScan();
    void stopMotor();

    [[nodiscard]] std::optional<RplidarReply> ask(
        const Bytes& request, RplidarAnswer type, std::chrono::milliseconds timeout);
    [[nodiscard]] std::optional<Bytes> askConfig(
        RplidarConfig question, std::optional<std::uint16_t> mode = std::nullopt);
    void send(RplidarCommand command, const Bytes& payload = {});
    void receive(std::chrono::milliseconds timeout);

    std::unique_ptr<SerialPort> port_;
    double max_gap_deg_;
    RplidarParser parser_;
    RplidarInfo info_;
    RplidarHealthReport health_;
    std::vector<RplidarMode> modes_;
    RplidarMode mode_;
};
}  // namespace rtob

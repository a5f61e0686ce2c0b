// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/range_source.h>
#include <rtob/devices/rplidar_encoder.h>

#include <cstdint>
#include <string>
#include <vector>

namespace rtob::devices
{
/// A way to scan that the emulated device offers.
struct EmulatedMode
{
    std::string name;
    RplidarScanKind kind = RplidarScanKind::Standard;
    double sample_s = 0.0005;
};

struct RplidarModel
{
    std::uint8_t model = 0x18;  ///< A1M8
    std::uint8_t firmware_major = 1, firmware_minor = 29;
    unsigned baud = 115200;
    double turns_hz = 5.5;
    double max_range_m = 12;
    std::vector<EmulatedMode> modes;
    std::size_t typical_mode = 0;
};
/// As their makers describe them: 5.5 Hz and 10 Hz, 115200 to 1000000 baud.
[[nodiscard]] RplidarModel model_a1();
[[nodiscard]] RplidarModel model_a2();
[[nodiscard]] RplidarModel model_a3();
[[nodiscard]] RplidarModel model_s2();

/// An RPLidar without its line.
class RplidarEmulator : public EmulatedDevice
{
 public:
    RplidarEmulator(RplidarModel model, RangeSource ranges);

    void receive(const Packet& bytes, double now_s) override;
    [[nodiscard]] std::vector<Packet> send(double now_s) override;
    void restart() override;
    /// It stops; questions for its health are answered with an error, until a reset.
    void breakDown() override;

    [[nodiscard]] bool isScanning() const { return is_scanning_; }
    [[nodiscard]] const RplidarModel& model() const { return model_; }

    /// The angle of the head [deg], growing for ever, from the start of the scan on.
    [[nodiscard]] double shaftDeg(double time_s) const;

 private:
    [[nodiscard]] std::size_t requestLength() const;
    void answer(const std::vector<std::uint8_t>& request, double now_s);
    void answerConfig(const std::vector<std::uint8_t>& request);
    void reply(std::uint8_t type, const Packet& payload);
    void startScan(const EmulatedMode& mode, double now_s);
    [[nodiscard]] Packet nextPacket();

    RplidarModel model_;
    RangeSource ranges_;
    std::vector<std::uint8_t> received_;
    std::vector<Packet> replies_;
    bool is_scanning_ = false, has_error_ = false, is_first_packet_ = false;
    EmulatedMode mode_;
    double scan_start_s_ = 0;
    std::uint64_t beams_sent_ = 0;
    double last_shaft_deg_ = 0;  ///< of the beam before
    double line_free_s_ = 0;     ///< when the packet before has left
};
}  // namespace rtob::devices

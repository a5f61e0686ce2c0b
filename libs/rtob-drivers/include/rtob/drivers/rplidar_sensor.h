// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/hwdrivers/CGenericSensor.h>
#include <mrpt/system/COutputLogger.h>
#include <rtob/drivers/back_off.h>
#include <rtob/drivers/rplidar_device.h>
#include <rtob/drivers/rplidar_scan.h>
#include <rtob/drivers/sensor_status.h>

#include <memory>
#include <mutex>

namespace rtob
{
/// `driver = RtobRplidar`: an RPLidar as a sensor of MRPT, for `rawlog-grabber -p` and
/// rtob-onboard. Each scan comes with a record of its sweep before it (scan_timing.h). Once it has
/// worked, a device that falls silent, errs or is unplugged is looked for until it is back.
class RtobRplidar : public mrpt::hwdrivers::CGenericSensor,
                    public mrpt::system::COutputLogger,
                    public TellsStatus
{
    DEFINE_GENERIC_SENSOR(RtobRplidar)

 public:
    RtobRplidar();
    ~RtobRplidar() override;

    /// Connects; throws PortError where that fails.
    void initialize() override;
    /// Waits a little for bytes and appends the scans that they complete. Never throws.
    void doProcess() override;

    [[nodiscard]] SensorStatus status() const override;
    [[nodiscard]] RplidarCounters counters() const;
    /// What the device offers, for a person: "Standard (0.5 ms a beam), ..."
    [[nodiscard]] std::string modesText() const;

 protected:
    void loadConfig_sensorSpecific(
        const mrpt::config::CConfigFileBase& config, const std::string& section) override;

 private:
    void connect();
    void disconnect(const std::string& problem);
    void tryToReconnect();
    void append(const RplidarRevolution& revolution);
    void checkSilence();
    [[nodiscard]] double deviceRange() const;

    RplidarOptions options_;
    std::unique_ptr<RplidarScanMaker> maker_;
    std::unique_ptr<RplidarDevice> device_;
    BackOff back_off_;
    BackOff::Clock::time_point last_revolution_{}, last_packet_{};
    std::uint64_t packets_seen_ = 0;
    RplidarCounters counters_of_past_;  ///< of connections that are over

    mutable std::mutex mutex_;  ///< guards what other threads may ask for
    SensorStatus status_;
    RplidarCounters counters_;
};
}  // namespace rtob

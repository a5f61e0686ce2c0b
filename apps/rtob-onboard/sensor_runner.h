// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/hwdrivers/CGenericSensor.h>
#include <mrpt/obs/CObservation.h>
#include <rtob/drivers/device_clock.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "onboard_config.h"

namespace rtob
{
/// How a sensor has been doing.
struct SensorReport
{
    std::string name, driver, device;
    bool is_working = false;
    std::string problem;  ///< the last one; empty while all is well
    std::uint64_t observations = 0, restarts = 0;
};

/// Drives one sensor in a thread of its own: starts it, asks it, and starts it anew after a pause
/// when it fails or falls silent. The others never notice.
class SensorRunner : public std::enable_shared_from_this<SensorRunner>
{
 public:
    using Sink = std::function<void(mrpt::obs::CObservation::Ptr)>;

    /// @param ini outlives this object
    [[nodiscard]] static std::shared_ptr<SensorRunner> start(
        const mrpt::config::CConfigFileBase& ini, const SensorSection& section, Sink sink);

    void askToEnd() { ends_ = true; }
    /// Whether it has ended; a driver that hangs in its hardware may not within this time.
    [[nodiscard]] bool waitForEnd(std::chrono::milliseconds patience) const;

    [[nodiscard]] SensorReport report() const;

 private:
    SensorRunner(const mrpt::config::CConfigFileBase& ini, SensorSection section, Sink sink);

    void live();
    void serve();
    void pass(mrpt::hwdrivers::CGenericSensor& sensor);
    [[nodiscard]] mrpt::Clock::time_point arrived(mrpt::Clock::time_point driver_stamp);
    void noteState(const mrpt::hwdrivers::CGenericSensor& sensor);
    void pause(std::chrono::steady_clock::duration duration);

    const mrpt::config::CConfigFileBase& ini_;
    SensorSection section_;
    Sink sink_;
    DeviceClock laser_clock_;
    std::chrono::steady_clock::time_point last_observation_{};
    /// Outside its driver: one that hangs shows nothing any more.
    std::atomic<std::chrono::steady_clock::time_point> last_seen_{std::chrono::steady_clock::now()};
    std::atomic<bool> ends_{false}, has_ended_{false};
    mutable std::mutex mutex_;
    SensorReport report_;
};

/// A driver that prints nothing: its problems stand in the reports. Throws where there is none.
/// @param where the place in the configuration, for the message
[[nodiscard]] std::unique_ptr<mrpt::hwdrivers::CGenericSensor> create_quiet_sensor(
    const std::string& driver, const std::string& where);

/// What went wrong, without MRPT's call stacks and places in its sources.
[[nodiscard]] std::string plain_message(const std::exception& error);
}  // namespace rtob

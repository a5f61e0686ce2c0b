// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/hwdrivers/CGenericSensor.h>
#include <rtob/drivers/sensor_status.h>
#include <rtob/io/log_reader.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace rtob
{
/// The keys of a sensor section with `driver = RtobLogPlayer`, beside those of any sensor.
struct LogPlayerOptions
{
    std::string file;
    double speed = 1;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("file", s.file, "the log: a rawlog of either format or a CARMEN log");
        visit("speed", s.speed, "times faster than it was recorded; 0.01 to 100");
    }
    void validate() const;
};

/// `driver = RtobLogPlayer`: a log as if it happened now. Each observation comes when it is due,
/// with the time of now, its own label and its own mount; motions of logs that hold them come as
/// odometry. What a live program added to the log (its poses, its marks) is left out.
class RtobLogPlayer : public mrpt::hwdrivers::CGenericSensor, public TellsStatus
{
    DEFINE_GENERIC_SENSOR(RtobLogPlayer)

 public:
    /// Opens the log; throws LogError.
    void initialize() override;
    void doProcess() override;
    [[nodiscard]] SensorStatus status() const override;

 protected:
    void loadConfig_sensorSpecific(
        const mrpt::config::CConfigFileBase& config, const std::string& section) override;

 private:
    void readNext();
    void takeIn(LogEntry entry);
    [[nodiscard]] double shifted(double log_s) const;

    LogPlayerOptions options_;
    std::unique_ptr<LogReader> log_;
    mrpt::obs::CObservation::Ptr next_;         ///< null: the log has ended
    double next_stamp_s_ = 0, next_due_s_ = 0;  ///< UNIX seconds
    std::optional<double> first_log_s_;
    double begin_s_ = 0;
    double last_log_s_ = 0;  ///< of the entry before: motions may have no stamp
    double sweep_s_ = 0;     ///< of the scan after a timing record, which comes when it is complete
    mrpt::poses::CPose2D pose_odom_vehicle_;
    mutable std::mutex mutex_;  ///< guards what other threads may ask for
    SensorStatus status_;
};
}  // namespace rtob

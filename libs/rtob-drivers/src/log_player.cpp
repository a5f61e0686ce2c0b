// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <rtob/core/option_checks.h>
#include <rtob/drivers/log_player.h>
#include <rtob/drivers/sensor_section.h>
#include <rtob/drivers/unix_time.h>
#include <rtob/io/scan_timing.h>

#include <algorithm>

IMPLEMENTS_GENERIC_SENSOR(RtobLogPlayer, rtob)

namespace rtob
{
namespace
{
bool is_a_programs_own(const mrpt::obs::CObservation& observation)
{
    return is_dropped_record(observation) ||
           dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&observation) != nullptr;
}
}  // namespace

void LogPlayerOptions::validate() const
{
    require(!file.empty(), "file", file, "the name of a log");
    require(speed >= 0.01 && speed <= 100, "speed", speed, "0.01 to 100");
}

void RtobLogPlayer::loadConfig_sensorSpecific(
    const mrpt::config::CConfigFileBase& config, const std::string& section)
{
    load_sensor_options(config, section, options_);
}

void RtobLogPlayer::initialize()
{
    log_ = open_log(options_.file);
    first_log_s_.reset();
    begin_s_ = next_due_s_ = unix_time_s();
    pose_odom_vehicle_ = {};
    sweep_s_ = 0;
    readNext();
    m_state = ssWorking;
    const std::lock_guard lock(mutex_);
    status_.is_connected = true;
    status_.device = "log " + options_.file;
}

void RtobLogPlayer::doProcess()
{
    const double now_s = unix_time_s();
    // MRPT sorts what comes at once by stamp: one that steps back waits for the next time.
    double last_stamp_s = 0;
    while (next_ && next_due_s_ <= now_s && next_stamp_s_ >= last_stamp_s)
    {
        last_stamp_s = next_stamp_s_;
        appendObservation(next_);
        readNext();
    }
}

void RtobLogPlayer::readNext()
{
    next_.reset();
    try
    {
        while (!next_)
        {
            auto entry = log_->next();
            if (!entry) break;
            takeIn(std::move(*entry));
        }
        if (next_) return;
    }
    catch (const LogError& error)
    {
        const std::lock_guard lock(mutex_);
        status_.problem = error.what();
        return;
    }
    const std::lock_guard lock(mutex_);
    status_.device = "log " + options_.file + ", played to its end";
}

/// Makes an entry of the log the next observation, where it is to be played.
void RtobLogPlayer::takeIn(LogEntry entry)
{
    if (entry.motion)
    {
        pose_odom_vehicle_ = pose_odom_vehicle_ + entry.motion->poseChange->getMeanVal();
        auto odometry = mrpt::obs::CObservationOdometry::Create();
        odometry->odometry = pose_odom_vehicle_;
        odometry->sensorLabel = "ODOMETRY";
        odometry->timestamp = entry.motion->timestamp;
        entry.observation = odometry;
    }
    if (is_a_programs_own(*entry.observation)) return;
    const bool has_time = entry.observation->timestamp != INVALID_TIMESTAMP;
    if (!has_time && !first_log_s_) return;  // nobody knows when
    const double log_s =
        has_time ? mrpt::Clock::toDouble(entry.observation->timestamp) : last_log_s_;
    last_log_s_ = log_s;
    if (!first_log_s_) first_log_s_ = log_s;
    if (const auto timing = read_timing_record(*entry.observation))
    {
        sweep_s_ = timing->sweep_s / options_.speed;
        dynamic_cast<mrpt::obs::CObservationRawDAQ&>(*entry.observation).AIN_double = {sweep_s_};
    }
    next_ = std::move(entry.observation);
    next_stamp_s_ = shifted(log_s);
    next_->timestamp = mrpt::Clock::fromDouble(next_stamp_s_);
    next_due_s_ = std::max(next_due_s_, next_stamp_s_ + sweep_s_);
    if (dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(next_.get()) != nullptr)
        sweep_s_ = 0;
}

double RtobLogPlayer::shifted(double log_s) const
{
    return begin_s_ + (log_s - *first_log_s_) / options_.speed;
}

SensorStatus RtobLogPlayer::status() const
{
    const std::lock_guard lock(mutex_);
    return status_;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/poses/CPose3DQuat.h>
#include <rtob/io/tum_log.h>

#include <cmath>

#include "data_lines.h"
#include "mrpt_clock.h"
#include "tum_line.h"

namespace rtob
{
namespace
{
mrpt::poses::CPose3D pose_of(const TumLine& line)
{
    mrpt::math::CQuaternionDouble turn(line.qw, line.qx, line.qy, line.qz);
    turn.normalize();
    return mrpt::poses::CPose3D(mrpt::poses::CPose3DQuat(line.x, line.y, line.z, turn));
}

class TumLogReader : public LogReader
{
 public:
    TumLogReader(const std::string& file, PoseMeaning meaning)
        : lines_(file, tum_line_fix), meaning_(meaning)
    {
    }

    [[nodiscard]] std::optional<LogEntry> next() override
    {
        const auto line = lines_.next(parse_tum_line);
        if (!line) return std::nullopt;
        return meaning_ == PoseMeaning::RobotPose ? robotPose(*line) : odometry(*line);
    }
    [[nodiscard]] double progress() const override { return lines_.progress(); }
    [[nodiscard]] LogLosses losses() const override { return losses_; }

 private:
    static LogEntry robotPose(const TumLine& line)
    {
        auto observation = mrpt::obs::CObservationRobotPose::Create();
        observation->timestamp = clock_of(line.stamp_100ns);
        observation->sensorLabel = "pose";
        observation->pose.mean = pose_of(line);
        return {observation, nullptr};
    }

    LogEntry odometry(const TumLine& line)
    {
        constexpr double flat = 1e-6;
        const auto pose = pose_of(line);
        if (std::abs(pose.z()) > flat) ++losses_["heights: odometry lies in the plane"];
        if (std::abs(pose.pitch()) > flat || std::abs(pose.roll()) > flat)
            ++losses_["pitch and roll: odometry lies in the plane"];
        auto observation = mrpt::obs::CObservationOdometry::Create();
        observation->timestamp = clock_of(line.stamp_100ns);
        observation->sensorLabel = "odometry";
        observation->odometry = mrpt::poses::CPose2D(pose);
        return {observation, nullptr};
    }

    DataLines lines_;
    PoseMeaning meaning_;
    LogLosses losses_;
};
}  // namespace

bool is_tum_file(const std::string& file)
try
{
    LineSource lines(file);
    while (const auto line = lines.next())
    {
        TextFields fields(*line);
        const auto first = fields.next_word();
        if (first.empty() || first.front() == '#') continue;
        static_cast<void>(TextFields(first).number("time"));
        return true;
    }
    return false;
}
catch (const FieldError&)
{
    return false;
}
catch (const ByteSourceError& error)
{
    throw LogError(file, "", error.what(), error.fix());
}

std::unique_ptr<LogReader> open_tum_log(const std::string& file, PoseMeaning meaning)
{
    return std::make_unique<TumLogReader>(file, meaning);
}
}  // namespace rtob

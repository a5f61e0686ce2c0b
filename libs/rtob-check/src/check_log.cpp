// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/check/check_log.h>
#include <rtob/check/laser_check.h>
#include <rtob/io/log_reader.h>
#include <rtob/map/conversions.h>

#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

namespace rtob
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;

constexpr std::size_t kMostLasers = 8;

/// The vehicle's latest odometry, from poses or from motions.
class OdometryTrack
{
 public:
    void add(const LogEntry& entry)
    {
        if (entry.motion)
            move(to_pose2(entry.motion->poseChange->getMeanVal()));
        else if (
            const auto* odometry =
                dynamic_cast<const CObservationOdometry*>(entry.observation.get()))
            set(to_pose2(odometry->odometry));
    }
    [[nodiscard]] const std::optional<Pose2>& pose() const { return pose_odom_vehicle_; }

 private:
    void set(const Pose2& pose)
    {
        if (is_finite(pose)) pose_odom_vehicle_ = pose;
    }
    void move(const Pose2& pose_prev_now)
    {
        set(compose(pose_odom_vehicle_.value_or(Pose2{}), pose_prev_now));
    }

    std::optional<Pose2> pose_odom_vehicle_;
};

/// Gives out the entries of a log up to its end or to where it is damaged.
class LogPass
{
 public:
    LogPass(const std::string& file, const CheckProgress& progress, double done_before)
        : log_(open_log(file)), progress_(progress), done_before_(done_before), file_(file)
    {
    }

    [[nodiscard]] std::optional<LogEntry> next()
    {
        constexpr unsigned entries_between = 256;
        if (++entries_ % entries_between == 0 && !progress_(done_before_ + log_->progress() / 2))
            throw std::runtime_error(file_ + ": the check was stopped.");
        try
        {
            return log_->next();
        }
        catch (const LogError& error)
        {
            damage_ = error.what();
            return std::nullopt;
        }
    }
    [[nodiscard]] const std::string& damage() const { return damage_; }

 private:
    std::unique_ptr<LogReader> log_;
    const CheckProgress& progress_;
    double done_before_;
    std::string file_, damage_;
    unsigned entries_ = 0;
};

class LogCheck
{
 public:
    void readScans(LogPass pass)
    {
        while (const auto entry = pass.next())
        {
            const auto* scan =
                dynamic_cast<const CObservation2DRangeScan*>(entry->observation.get());
            if (!scan)
                ++others_;
            else if (lasers_.size() < kMostLasers || lasers_.count(scan->sensorLabel) > 0)
                lasers_[scan->sensorLabel].add(*scan);
        }
        damage_ = pass.damage();
    }

    void readMotion(LogPass pass)
    {
        for (const auto& [label, laser] : lasers_)
            motions_.try_emplace(label, laser.filterOptions(), laser.usualInterval());
        OdometryTrack odometry;
        while (const auto entry = pass.next())
        {
            odometry.add(*entry);
            const auto* scan =
                dynamic_cast<const CObservation2DRangeScan*>(entry->observation.get());
            if (!scan) continue;
            const auto motion = motions_.find(scan->sensorLabel);
            if (motion != motions_.end()) motion->second.add(*scan, odometry.pose());
        }
    }

    void requireScans(const std::string& file) const
    {
        if (!lasers_.empty()) return;
        if (!damage_.empty()) throw std::runtime_error(damage_);
        throw std::runtime_error(
            file + ": the log holds no 2D laser scan (" + std::to_string(others_) +
            " other entries). Name a log with CObservation2DRangeScan entries, or FLASER or "
            "ROBOTLASER1 lines.");
    }

    [[nodiscard]] CheckReport report() const
    {
        CheckReport report;
        if (!damage_.empty())
            report.findings.push_back(
                {Severity::Fail,
                 "log.damage",
                 damage_,
                 "What comes before was checked; run ends there, too",
                 {}});
        for (const auto& [label, laser] : lasers_)
        {
            const std::size_t before = report.findings.size();
            laser.report(report);
            motions_.at(label).report(report);
            if (lasers_.size() == 1) continue;
            for (std::size_t i = before; i < report.findings.size(); ++i)
                report.findings[i].laser = label;
        }
        return report;
    }

 private:
    std::map<std::string, LaserCheck> lasers_;
    std::map<std::string, MotionCheck> motions_;
    std::string damage_;
    std::uint64_t others_ = 0;
};
}  // namespace

CheckReport check_log(const std::string& file, const CheckProgress& progress)
{
    LogCheck check;
    check.readScans(LogPass(file, progress, 0));
    check.requireScans(file);
    check.readMotion(LogPass(file, progress, 0.5));
    return check.report();
}
}  // namespace rtob

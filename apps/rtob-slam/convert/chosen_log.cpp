// SPDX-License-Identifier: BSD-3-Clause
#include "convert/chosen_log.h"

#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <rtob/io/no_return.h>

#include <algorithm>
#include <stdexcept>

namespace rtob
{
namespace
{
using namespace mrpt::obs;

bool is_chosen(const std::vector<std::string>& labels, const std::string& label)
{
    return labels.empty() || std::find(labels.begin(), labels.end(), label) != labels.end();
}

bool is_pose(const CObservation& observation)
{
    return dynamic_cast<const CObservationOdometry*>(&observation) != nullptr ||
           dynamic_cast<const CObservationRobotPose*>(&observation) != nullptr;
}
}  // namespace

ChosenLog::ChosenLog(
    std::unique_ptr<LogReader> log, LogChoice choice, const std::function<bool()>& stop)
    : log_(std::move(log)), choice_(std::move(choice)), stop_(stop)
{
}

std::optional<LogEntry> ChosenLog::next()
{
    while (auto entry = log_->next())
    {
        if (stop_()) throw std::runtime_error("stopped by a signal; nothing was written.");
        if (wants(*entry)) return limited(*entry);
    }
    return std::nullopt;
}

bool ChosenLog::wants(const LogEntry& entry)
{
    if (entry.motion) return true;
    const auto& observation = *entry.observation;
    const bool is_scan = dynamic_cast<const CObservation2DRangeScan*>(&observation) != nullptr;
    if (!is_scan && !is_pose(observation)) return true;
    const auto& wanted = is_scan ? choice_.lasers : choice_.poses;
    if (is_chosen(wanted, observation.sensorLabel)) return true;
    const std::string kind = is_scan ? "scans of laser '" : "poses of sensor '";
    ++losses_[kind + observation.sensorLabel + "', which was not chosen"];
    return false;
}

LogEntry ChosenLog::limited(const LogEntry& entry) const
{
    const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(entry.observation.get());
    if (scan == nullptr) return entry;
    if (choice_.max_range_m) return {with_max_range(*scan, *choice_.max_range_m), nullptr};
    const auto no_return = choice_.no_return_m.find(scan->sensorLabel);
    if (no_return == choice_.no_return_m.end() || !lacks_max_range(*scan)) return entry;
    return {with_max_range(*scan, no_return->second), nullptr};
}

LogLosses ChosenLog::losses() const
{
    LogLosses all = log_->losses();
    for (const auto& [what, times] : losses_) all[what] += times;
    return all;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "compare/log_survey.h"

#include <stdexcept>

#include "compare/scan_steps.h"

namespace rtob
{
LogSurvey survey_log(const std::string& log, const RunConfig& config, const RunLimits& limits)
{
    LogSurvey survey;
    ScanSteps steps(log, config, limits);
    while (const auto step = steps.next())
    {
        const bool has_stamp = step->scan->timestamp != INVALID_TIMESTAMP;
        const double stamp_s = has_stamp ? mrpt::Clock::toDouble(step->scan->timestamp) : 0;
        if (!survey.scans.empty() && stamp_s < survey.scans.back().time_s) ++survey.stamps_back;
        survey.scans.push_back({stamp_s, {}});
        survey.duration_s = step->time_s;
        survey.has_odometry = survey.has_odometry || step->pose_odom_vehicle.has_value();
    }
    survey.read = steps.read();
    if (survey.scans.empty()) throw std::runtime_error(no_scans_message(log, survey.read));
    return survey;
}
}  // namespace rtob

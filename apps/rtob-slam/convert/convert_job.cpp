// SPDX-License-Identifier: BSD-3-Clause
#include "convert/convert_job.h"

#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <rtob/io/carmen_writer.h>
#include <rtob/io/rawlog_writer.h>
#include <rtob/io/tum_log.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "usage_error.h"

namespace rtob
{
namespace
{
namespace fs = std::filesystem;

void check_files(const ConvertJob& job)
{
    std::error_code ignored;
    if (fs::equivalent(job.log, job.output, ignored))
        throw UsageError("LOG and OUTPUT are the same file");
    if (fs::is_directory(job.output, ignored))
        throw std::runtime_error(job.output + ": this is a folder. Name a file.");
    if (fs::exists(job.output, ignored) && !job.may_overwrite)
        throw std::runtime_error(job.output + " exists. Name another file, or add --overwrite.");
}

PoseMeaning meaning_of(bool is_odometry)
{
    return is_odometry ? PoseMeaning::Odometry : PoseMeaning::RobotPose;
}

class Source
{
 public:
    Source(const ConvertJob& job, const std::function<bool()>& stop)
        : job_(job), stop_(stop), is_tum_(is_tum_file(job.log))
    {
        if (is_tum_ && job.target != ConvertTarget::Rawlog)
            throw UsageError(
                job.log + " is a TUM file: it holds poses only, and can become a .rawlog");
        const bool speaks_of_tum = is_tum_ || job.target == ConvertTarget::Tum;
        if (job.poses_are_odometry && !speaks_of_tum)
            throw UsageError("--odometry says what the poses of a TUM file are; this is none");
    }

    [[nodiscard]] ChosenLog open(const LogChoice& choice) const
    {
        auto log = is_tum_ ? open_tum_log(job_.log, meaning_of(job_.poses_are_odometry))
                           : open_log(job_.log);
        return {std::move(log), choice, stop_};
    }

 private:
    const ConvertJob& job_;
    const std::function<bool()>& stop_;
    bool is_tum_;
};

void check_labels(
    const std::vector<std::string>& chosen, const std::vector<std::string>& seen,
    const std::string& what)
{
    for (const auto& label : chosen)
        if (std::find(seen.begin(), seen.end(), label) == seen.end())
            throw std::runtime_error(
                "the log has no " + what + " '" + label +
                "'. `rawlog-edit --info` lists the labels of a rawlog; those of a CARMEN log are "
                "laser_front, laser_rear and odometry.");
}

/// What was asked for is there.
void check_contents(const ConvertJob& job, const LogContents& contents)
{
    if (!contents.damage.empty() && !job.keep_part)
        throw std::runtime_error(contents.damage + " --keep-part converts what comes before.");
    std::vector<std::string> lasers, poses;
    for (const auto& laser : contents.lasers) lasers.push_back(laser.label);
    for (const auto* sensors : {&contents.odometry, &contents.robot_poses})
        for (const auto& [label, count] : *sensors) poses.push_back(label);
    check_labels(job.choice.lasers, lasers, "laser");
    check_labels(job.choice.poses, poses, "odometry or robot poses");
    if (lasers.empty() && poses.empty() && contents.motions == 0 && contents.others.empty())
        throw std::runtime_error(
            job.log +
            ": the log holds no scan, odometry or pose. Name a rawlog, a CARMEN log or "
            "a TUM file.");
}

std::unique_ptr<LogWriter> open_writer(const ConvertJob& job, const LogContents& contents)
{
    if (job.target == ConvertTarget::Rawlog) return std::make_unique<RawlogWriter>(job.output);
    if (job.target == ConvertTarget::Carmen)
        return std::make_unique<CarmenWriter>(job.output, contents);
    const bool takes_odometry = job.poses_are_odometry || contents.robot_poses.empty();
    return std::make_unique<TumLogWriter>(job.output, contents, meaning_of(takes_odometry));
}

void find_no_returns(const LogContents& contents, LogChoice& choice, Conversion& conversion)
{
    for (const auto& laser : contents.lasers)
        if (const auto no_return = laser.no_return.found())
        {
            choice.no_return_m[laser.label] = no_return->from_m;
            conversion.no_returns[laser.label] = *no_return;
        }
}

void count(const LogEntry& entry, Conversion& conversion)
{
    const auto* observation = entry.observation.get();
    if (entry.motion || dynamic_cast<const mrpt::obs::CObservationOdometry*>(observation))
        ++conversion.odometry;
    else if (dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(observation))
        ++conversion.scans;
    else if (dynamic_cast<const mrpt::obs::CObservationRobotPose*>(observation))
        ++conversion.robot_poses;
    else
        ++conversion.others;
}

void copy_entries(LogReader& log, LogWriter& out, Conversion& conversion)
{
    try
    {
        while (const auto entry = log.next())
        {
            count(*entry, conversion);
            out.write(*entry);
        }
    }
    catch (const LogError&)  // the survey has met it before, and it is to be kept up to there
    {
    }
}
}  // namespace

Conversion convert_log(const ConvertJob& job, const std::function<bool()>& stop)
{
    check_files(job);
    const Source source(job, stop);
    auto surveyed = source.open(job.choice);
    const LogContents contents = survey_log(surveyed);
    check_contents(job, contents);

    Conversion conversion;
    conversion.damage = contents.damage;
    LogChoice choice = job.choice;
    find_no_returns(contents, choice, conversion);
    auto log = source.open(choice);
    const auto out = open_writer(job, contents);
    copy_entries(log, *out, conversion);
    out->commit();
    conversion.losses = log.losses();
    for (const auto& [what, times] : out->losses()) conversion.losses[what] += times;
    return conversion;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "compare/compare_job.h"

#include <rtob/core/enum_names.h>
#include <rtob/eval/comparison_report.h>

#include <filesystem>

#include "compare/child_process.h"
#include "compare/log_survey.h"
#include "compare/machine.h"
#include "compare/run_plan.h"
#include "compare/truth.h"
#include "compare/variant_run.h"
#include "run/output_folder.h"

namespace rtob
{
namespace
{
namespace fs = std::filesystem;
constexpr const char* runs_name = "runs";

/// What an earlier comparison left would look like runs of this one.
void remove_old_runs(const fs::path& folder)
{
    if (!fs::is_directory(folder / runs_name)) return;
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(folder / runs_name))
        if (fs::exists(entry.path() / "job.json")) old.push_back(entry.path());
    for (const auto& run : old) fs::remove_all(run);
}

VariantJob job_for(
    const CompareJob& job, const VariantSpec& spec, const PlannedRun& planned,
    const std::string& folder)
{
    VariantJob run;
    run.log = job.log;
    run.folder = folder;
    run.config_file = job.config_file;
    run.sets = job.sets;
    run.limits = job.limits;
    run.kind = spec.kind;
    run.density = spec.density;
    run.variant_file = spec.config_file;
    run.seed = planned.seed;
    run.time_limit_s = job.time_limit_s;
    run.title = spec.name;
    if (spec.usesSeed()) run.title += ", seed " + std::to_string(planned.seed);
    return run;
}

ComparedRun begun_run(const PlannedRun& planned)
{
    ComparedRun run;
    run.seed = planned.seed;
    run.round = planned.round;
    return run;
}

ComparedRun run_without_odometry(const PlannedRun& planned)
{
    ComparedRun run = begun_run(planned);
    run.failure =
        "the log has no odometry, or it was left aside, and this variant is nothing but odometry";
    return run;
}

/// One run in a process of its own: its memory is its own, and so is its crash.
ComparedRun run_one(
    const CompareJob& job, const VariantSpec& spec, const PlannedRun& planned, const Truth& truth)
{
    ComparedRun run = begun_run(planned);
    run.folder = std::string(runs_name) + "/" + spec.name + "-" + std::to_string(planned.round);
    const fs::path folder = fs::path(job.folder) / run.folder;
    try
    {
        fs::create_directories(folder);
        write_job(folder / "job.json", job_for(job, spec, planned, folder));
        auto command = runner_of(spec.kind);
        const std::string program = command.front();
        command.erase(command.begin());
        command.push_back(folder / "job.json");
        run.failure = run_child(program, command, folder / "console.txt");
        if (run.failed()) return run;
        read_variant_run(folder, run);
        run.accuracy = truth.judge(run.trajectory);
    }
    catch (const std::exception& error)
    {
        run.failure = error.what();
    }
    return run;
}

std::vector<std::string> remarks_on(const LogSurvey& survey)
{
    std::vector<std::string> remarks;
    if (const auto load = machine_load(); load && !remark_on(*load).empty())
        remarks.push_back(remark_on(*load));
    if (!survey.has_odometry)
        remarks.emplace_back(
            "The log has no odometry, or it was left aside: RTOB-SLAM starts each scan from "
            "constant "
            "velocity, MRPT from its last pose.");
    if (survey.stamps_back > 0)
        remarks.push_back(
            "The log's stamps step back " + std::to_string(survey.stamps_back) +
            " times. Every program takes the scans in the order of the file and is told a time "
            "that does not run back.");
    if (survey.read.end == RunEnd::DamagedLog)
        remarks.push_back("The log was read up to where it is damaged: " + survey.read.damage);
    return remarks;
}

Comparison begun(
    const CompareJob& job, const std::vector<VariantSpec>& specs, const LogSurvey& survey)
{
    Comparison comparison;
    comparison.log = job.log;
    comparison.truth = job.truth;
    comparison.scans = survey.scans.size();
    comparison.duration_s = survey.duration_s;
    comparison.has_odometry = survey.has_odometry;
    comparison.command = job.command;
    comparison.machine = machine_facts();
    comparison.remarks = remarks_on(survey);
    for (const auto& spec : specs)
        comparison.variants.push_back(
            {spec.name,
             spec.description,
             spec.kind == VariantKind::Rtob ? job.config_file : spec.config_file,
             spec.usesSeed(),
             spec.kind == VariantKind::Odometry,
             {}});
    return comparison;
}
}  // namespace

Comparison do_compare(const CompareJob& job, const std::function<void(const std::string&)>& say)
{
    const OutputFolder folder(job.folder, job.may_overwrite);
    const Truth truth = job.truth.empty() ? Truth() : Truth(job.truth);
    const RunConfig config = load_run_config(job.config_file, parse_set_flags(job.sets));
    const LogSurvey survey = survey_log(job.log, config, job.limits);
    truth.checkTimes(survey.scans);  // before the long runs
    const auto specs = chosen_variants(job.choice);
    folder.create();
    remove_old_runs(job.folder);

    Comparison comparison = begun(job, specs, survey);
    comparison.truth_kind = truth.kind();
    const auto plan = plan_runs(specs, job.repeats, job.seeds);
    for (std::size_t i = 0; i < plan.size(); ++i)
    {
        const auto& spec = specs[plan[i].variant];
        say("[" + std::to_string(i + 1) + "/" + std::to_string(plan.size()) + "] " + spec.name);
        auto run = spec.needsOdometry() && !survey.has_odometry
                       ? run_without_odometry(plan[i])
                       : run_one(job, spec, plan[i], truth);
        if (run.failed()) say("  " + spec.name + " failed: " + run.failure);
        comparison.variants[plan[i].variant].runs.push_back(std::move(run));
    }
    write_comparison_report(job.folder, comparison);
    return comparison;
}
}  // namespace rtob

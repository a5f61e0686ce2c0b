// SPDX-License-Identifier: BSD-3-Clause
#include "tune/tune_job.h"

#include <rtob/core/enum_names.h>
#include <rtob/io/text_file.h>

#include <filesystem>

#include "run/output_folder.h"
#include "simulate/simulate_job.h"
#include "tune/tune_runs.h"

namespace rtob
{
namespace
{
bool is_world(const std::string& source)
{
    return std::filesystem::path(source).extension() == ".yaml";
}

/// A world is flown once a seed, so that chance in the flight counts too.
std::vector<TuneFlight> flights_of(const TuneJob& job, const OutputFolder& folder)
{
    const bool odometry = job.config.run.use_odometry;
    if (!is_world(job.source))
        return {read_flight(job.source, job.truth, job.first_scans, odometry)};
    std::vector<TuneFlight> flights;
    for (int seed = 1; seed <= job.seeds; ++seed)
    {
        SimulateJob flight;
        flight.world = job.source;
        flight.log = folder.file("flight-" + std::to_string(seed) + ".rawlog");
        flight.truth = default_truth_file(flight.log);
        flight.seed = static_cast<std::uint64_t>(seed);
        flight.may_overwrite = true;
        simulate(flight);
        flights.push_back(read_flight(flight.log, flight.truth, job.first_scans, odometry));
    }
    return flights;
}

std::vector<RunConfig> settings_of(const Sweep& sweep, const RunConfig& config)
{
    std::vector<RunConfig> settings;
    for (const auto& value : sweep.values) settings.push_back(config_with(config, sweep, value));
    return settings;
}

TuneCurve measured(
    const Sweep& sweep, const RunConfig& config, const TuneRuns& runs, bool time_only = false)
{
    const auto settings = settings_of(sweep, config);
    std::vector<TuneFigures> figures(settings.size());
    if (!time_only) runs.measureAccuracy(settings, figures);
    runs.measureTime(settings, figures);
    TuneCurve curve{sweep, value_in(config, sweep), {}};
    for (std::size_t i = 0; i < settings.size(); ++i)
        curve.points.push_back({sweep.values[i], figures[i]});
    return curve;
}

/// The constants of a density matter where that density was chosen.
bool matters(const Sweep& sweep, const RunConfig& config)
{
    return sweep.density.empty() || name_of(config.slam.density.density) == sweep.density;
}

bool costs_time(const Sweep& sweep)
{
    return sweep.name() == "Draw.points" || sweep.name() == "Icp.iterations";
}

/// First what costs little: density, its constants, pair distance. Then, with those, as many points
/// as there is time for, and with those as many iterations.
RunConfig choose(const TuneJob& job, const TuneRuns& runs, const std::vector<TuneCurve>& curves)
{
    RunConfig config = job.config;
    for (const bool costly : {false, true})
        for (const auto& curve : curves)
        {
            if (costs_time(curve.sweep) != costly || !matters(curve.sweep, config)) continue;
            TuneCurve here = curve;
            if (costly)
            {
                const auto timed = measured(curve.sweep, config, runs, true);
                for (std::size_t i = 0; i < here.points.size(); ++i)
                {
                    here.points[i].figures.p50_ms = timed.points[i].figures.p50_ms;
                    here.points[i].figures.p99_ms = timed.points[i].figures.p99_ms;
                }
            }
            const auto value = chosen_value(here, job.budget_ms);
            if (!value.empty()) config = config_with(config, curve.sweep, value);
        }
    return config;
}

void write(const std::string& file, const std::string& text)
{
    TextFile out(file);
    out.stream() << text;
    out.commit();
}
}  // namespace

TuneResult tune(const TuneJob& job, const std::function<void(const std::string&)>& progress)
{
    if (!is_world(job.source) && job.truth.empty())
        throw std::runtime_error(
            job.source + ": a log needs --truth FILE, poses to judge accuracy by; or give a world");
    const OutputFolder folder(job.folder, job.may_overwrite);
    folder.create();
    std::string doing = "reading";
    progress(doing);
    const TuneRuns runs(
        flights_of(job, folder), job.seeds,
        [&](std::size_t over, std::size_t all)
        { progress(doing + ", run " + std::to_string(over) + " of " + std::to_string(all)); });
    TuneResult result;
    for (const auto& sweep : tuning_sweeps())
    {
        doing = sweep.name();
        result.curves.push_back(measured(sweep, job.config, runs));
    }
    doing = "choosing";
    result.suggested = choose(job, runs, result.curves);
    std::vector<TuneFigures> both(2);
    runs.measureAccuracy({job.config, result.suggested}, both);
    runs.measureTime({job.config, result.suggested}, both);
    result.before = both[0];
    result.after = both[1];
    write(folder.file("tune.ini"), tuning_ini(job, result));
    write(folder.file("tune.md"), tuning_text(job, result));
    for (const auto& curve : result.curves)
        write(folder.file(curve.sweep.name() + ".svg"), tuning_plot(curve, job.budget_ms));
    return result;
}
}  // namespace rtob
